/** The shapes that questions and answers are made of. */

export type Vec2 = readonly [number, number];
export type Vec3 = readonly [number, number, number];

/** A zonotope of space: its centre, and its generators as half of the segments that they are. */
export interface Body {
  readonly center: Vec3;
  readonly generators: readonly Vec3[];
}

/** A number of an answer; those beyond the doubles come as words. */
export type AnyNumber = number | "Infinity" | "-Infinity" | "NaN";

/** A number as it stands, or as a fraction. */
export type Exact = number | string;

export type Status = "inside" | "boundary" | "outside";

/** The proof of a location: a direction that separates, or coefficients that write the point as one of the body. */
export type LocationProof =
  | { readonly separating_direction: readonly Exact[] }
  | { readonly coefficients: readonly number[]; readonly basis: readonly number[] };
