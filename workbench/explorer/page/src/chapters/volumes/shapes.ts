/** The meshes that the chapter begins with, made here: their triangles are seen from outside counter-clockwise. */

import { add3, cross3, length3, scale3, sub3, tidy3 } from "../../kit/vectors";
import type { MeshData } from "../../library/meshes";
import type { Vec3 } from "../../library/shapes";

const TURN = 2 * Math.PI;

/** The surface of a grid that closes upon itself in one way or in both. */
function grid(rows: number, columns: number, closed: boolean, at: (u: number, v: number) => Vec3): MeshData {
  const vertices: Vec3[] = [];
  for (let row = 0; row < rows + (closed ? 0 : 1); row += 1) {
    for (let column = 0; column < columns; column += 1) vertices.push(tidy3(at(row / rows, column / columns)));
  }
  const name = (row: number, column: number) => (row % (closed ? rows : rows + 1)) * columns + (column % columns);
  const triangles: Vec3[] = [];
  for (let row = 0; row < rows; row += 1) {
    for (let column = 0; column < columns; column += 1) {
      const [a, b] = [name(row, column), name(row, column + 1)];
      const [c, d] = [name(row + 1, column), name(row + 1, column + 1)];
      triangles.push([a, b, d], [a, d, c]);
    }
  }
  return { vertices, triangles: triangles.filter((one) => hasArea(one, vertices)) };
}

function hasArea([a, b, c]: Vec3, vertices: readonly Vec3[]): boolean {
  const [p, q, r] = [vertices[a] as Vec3, vertices[b] as Vec3, vertices[c] as Vec3];
  return length3(cross3(sub3(q, p), sub3(r, p))) > 1e-9;
}

/** Slices of a body of revolution about an axis, from its lower to its upper end. */
function turnedProfile(
  slices: number,
  around: number,
  profile: (u: number) => readonly [radius: number, height: number],
): MeshData {
  return grid(slices, around, false, (u, v) => {
    const [radius, height] = profile(u);
    return [radius * Math.cos(TURN * v), radius * Math.sin(TURN * v), height];
  });
}

/** The mesh turned so that the third axis leans to all three. */
function leaning({ vertices, triangles }: MeshData): MeshData {
  const w = scale3([1, 0.7, 0.9], 1 / length3([1, 0.7, 0.9]));
  const u = scale3(cross3([0, 0, 1], w), 1 / length3(cross3([0, 0, 1], w)));
  const v = cross3(w, u);
  const turned = ([x, y, z]: Vec3) => tidy3(add3(add3(scale3(u, x), scale3(v, y)), scale3(w, z)));
  return { vertices: vertices.map(turned), triangles };
}

/** Unit squares on the surface of the union of cubes of a grid. */
function ofCubes(cubes: readonly Vec3[], size: number): MeshData {
  const full = new Set(cubes.map(String));
  const names = new Map<string, number>();
  const vertices: Vec3[] = [];
  const middle = scale3(
    cubes.reduce((sum, cube) => add3(sum, add3(cube, [0.5, 0.5, 0.5])), [0, 0, 0] as Vec3),
    1 / cubes.length,
  );
  const corner = (place: Vec3) => {
    const known = names.get(String(place));
    if (known !== undefined) return known;
    names.set(String(place), vertices.length);
    return vertices.push(tidy3(scale3(sub3(place, middle), size))) - 1;
  };
  const triangles: Vec3[] = [];
  for (const cube of cubes) {
    for (let axis = 0; axis < 3; axis += 1) {
      for (const side of [0, 1]) {
        const unit = (k: number): Vec3 => [Number(k % 3 === 0), Number(k % 3 === 1), Number(k % 3 === 2)];
        if (full.has(String(add3(cube, scale3(unit(axis), side === 1 ? 1 : -1))))) continue;
        const from = add3(cube, scale3(unit(axis), side));
        const [u, v] = side === 1 ? [unit(axis + 1), unit(axis + 2)] : [unit(axis + 2), unit(axis + 1)];
        const [a, b, c, d] = [from, add3(from, u), add3(add3(from, u), v), add3(from, v)].map(corner);
        triangles.push([a as number, b as number, c as number], [a as number, c as number, d as number]);
      }
    }
  }
  return { vertices, triangles };
}

function blocks(width: number, depth: number, height: number): Vec3[] {
  return Array.from(
    { length: width * depth * height },
    (_, at): Vec3 => [at % width, Math.floor(at / width) % depth, Math.floor(at / (width * depth))],
  );
}

const ball = turnedProfile(9, 14, (u) => [Math.sin(Math.PI * u), -Math.cos(Math.PI * u)]);

/** The meshes by their names. */
export const SHAPES: Readonly<Record<string, MeshData>> = {
  ring: leaning(
    grid(9, 18, true, (u, v) => {
      const radius = 0.95 - 0.33 * Math.cos(TURN * u);
      return [radius * Math.cos(TURN * v), radius * Math.sin(TURN * v), -0.33 * Math.sin(TURN * u)];
    }),
  ),
  ball,
  angle: ofCubes([...blocks(2, 2, 5), ...blocks(3, 2, 2).map((one): Vec3 => [one[0] + 2, one[1], one[2]])], 0.4),
  needle: leaning(turnedProfile(24, 6, (u) => [0.09 * Math.sin(Math.PI * u), 3 * u - 1.5])),
  plate: leaning(ofCubes(blocks(8, 6, 1), 0.3)),
};
