/** Vectors of the plane and of space, for drawing alone: what is decided is decided by the library. */

import type { Vec2, Vec3 } from "../library/shapes";

export const add2 = (a: Vec2, b: Vec2): Vec2 => [a[0] + b[0], a[1] + b[1]];
export const sub2 = (a: Vec2, b: Vec2): Vec2 => [a[0] - b[0], a[1] - b[1]];
export const scale2 = (a: Vec2, t: number): Vec2 => [a[0] * t, a[1] * t];
export const cross2 = (a: Vec2, b: Vec2): number => a[0] * b[1] - a[1] * b[0];
export const length2 = (a: Vec2): number => Math.hypot(a[0], a[1]);

export const add3 = (a: Vec3, b: Vec3): Vec3 => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
export const sub3 = (a: Vec3, b: Vec3): Vec3 => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
export const scale3 = (a: Vec3, t: number): Vec3 => [a[0] * t, a[1] * t, a[2] * t];
export const dot3 = (a: Vec3, b: Vec3): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const cross3 = (a: Vec3, b: Vec3): Vec3 => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];
export const length3 = (a: Vec3): number => Math.hypot(a[0], a[1], a[2]);

/** A number with about that many digits, as it stands in a sentence. */
export function digits(value: number | string, count = 4): string {
  if (typeof value === "string") return value === "Infinity" ? "∞" : value;
  if (!Number.isFinite(value)) return value > 0 ? "∞" : value < 0 ? "−∞" : "not a number";
  if (value === 0) return "0";
  const size = Math.abs(value);
  const text =
    size >= 1e7 || size < 1e-4
      ? value
          .toExponential(count - 1)
          .replace(/\.?0+e/, "e")
          .replace("e+", "e")
      : value.toPrecision(count).includes("e")
        ? value.toFixed(0)
        : String(Number(value.toPrecision(count)));
  return text.replaceAll("-", "−");
}

export const place2 = (a: Vec2): string => `(${digits(a[0])}, ${digits(a[1])})`;
export const place3 = (a: Vec3): string => `(${digits(a[0])}, ${digits(a[1])}, ${digits(a[2])})`;

/** The nearest number with three digits after the point: what a drag leaves, so that links and commands stay short. */
export const tidy = (value: number): number => Math.round(value * 1000) / 1000 + 0;
export const tidy2 = (a: Vec2): Vec2 => [tidy(a[0]), tidy(a[1])];
export const tidy3 = (a: Vec3): Vec3 => [tidy(a[0]), tidy(a[1]), tidy(a[2])];

/** A source of random numbers between 0 and 1, the same for the same seed. */
export function randoms(seed: number): () => number {
  let state = seed >>> 0;
  return () => {
    state = (state + 0x6d2b79f5) >>> 0;
    let mixed = Math.imul(state ^ (state >>> 15), state | 1);
    mixed ^= mixed + Math.imul(mixed ^ (mixed >>> 7), mixed | 61);
    return ((mixed ^ (mixed >>> 14)) >>> 0) / 4294967296;
  };
}
