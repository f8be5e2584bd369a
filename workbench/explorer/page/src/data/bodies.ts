/** Generators of bodies with names, of polar zonohedra, and at random. */

import { randoms, tidy } from "../kit/vectors";
import type { Vec3 } from "../library/shapes";

const GOLDEN = (1 + Math.sqrt(5)) / 2;

export const CUBE: readonly Vec3[] = [
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
];
export const PARALLEL: readonly Vec3[] = [...CUBE, [0.5, 0, 0]];
export const RHOMBIC: readonly Vec3[] = [
  [1, 1, 1],
  [-1, 1, 1],
  [1, -1, 1],
  [1, 1, -1],
];
export const TRUNCATED: readonly Vec3[] = [
  [1, 1, 0],
  [1, -1, 0],
  [1, 0, 1],
  [1, 0, -1],
  [0, 1, 1],
  [0, 1, -1],
];
export const ICOSAHEDRAL: readonly Vec3[] = [
  [0, 1, GOLDEN],
  [0, 1, -GOLDEN],
  [1, GOLDEN, 0],
  [1, -GOLDEN, 0],
  [GOLDEN, 0, 1],
  [-GOLDEN, 0, 1],
];

/** Generators around the vertical axis, all with one slope. */
export function polar(count: number, rise: number): Vec3[] {
  return Array.from({ length: count }, (_, index): Vec3 => {
    const angle = (2 * Math.PI * index) / count + 0.1;
    return [tidy(Math.cos(angle)), tidy(Math.sin(angle)), rise];
  });
}

export function randomGenerators(seed: number, count: number): Vec3[] {
  const random = randoms(seed);
  return Array.from({ length: count }, (): Vec3 => {
    const height = 2 * random() - 1;
    const angle = 2 * Math.PI * random();
    const [size, wide] = [0.4 + random(), Math.sqrt(1 - height * height)];
    return [tidy(size * wide * Math.cos(angle)), tidy(size * wide * Math.sin(angle)), tidy(size * height)];
  });
}
