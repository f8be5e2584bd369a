/** Readers of what a link tells: each gives null for anything else than it expects. */

import type { Vec2, Vec3 } from "../library/shapes";

export function fields(told: unknown): Record<string, unknown> | null {
  return typeof told === "object" && told !== null && !Array.isArray(told) ? (told as Record<string, unknown>) : null;
}

export function finite(told: unknown): number | null {
  return typeof told === "number" && Number.isFinite(told) ? told : null;
}

export function within(told: unknown, least: number, most: number): number | null {
  const value = finite(told);
  return value !== null && value >= least && value <= most ? value : null;
}

export function vec2(told: unknown): Vec2 | null {
  return vector(told, 2) as Vec2 | null;
}

export function vec3(told: unknown): Vec3 | null {
  return vector(told, 3) as Vec3 | null;
}

export function list<Item>(told: unknown, read: (one: unknown) => Item | null, most: number): Item[] | null {
  if (!Array.isArray(told) || told.length > most) return null;
  const items = told.map(read);
  return items.every((item) => item !== null) ? (items as Item[]) : null;
}

function vector(told: unknown, dimension: number): number[] | null {
  const numbers = list(told, finite, dimension);
  return numbers?.length === dimension ? numbers : null;
}
