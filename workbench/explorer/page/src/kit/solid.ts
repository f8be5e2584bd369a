/** A convex solid as it is drawn: facets with colours, and edges above them. */

import {
  BufferAttribute,
  BufferGeometry,
  Color,
  DoubleSide,
  FrontSide,
  LineBasicMaterial,
  LineSegments,
  Matrix4,
  Mesh,
  MeshLambertMaterial,
  type Object3D,
} from "three";
import type { Faces } from "../library/pictures";
import type { Vec2, Vec3 } from "../library/shapes";
import { cross3, dot3, length3, scale3, sub3 } from "./vectors";

export interface SolidLook {
  /** The colour of each facet, as #rrggbb. */
  readonly facets: readonly string[];
  readonly opacity: number;
  /** The colour of the edges. */
  readonly edge: string;
  /** Whether facets are seen from behind, as those of a surface that may have an edge. */
  readonly isTwoSided?: boolean;
}

export interface SolidShape {
  readonly vertices: readonly Vec3[];
  /** The vertices of each facet, counter-clockwise from outside. */
  readonly facets: readonly (readonly number[])[];
  /** The ends of all edges, one edge after the other. */
  readonly ends: ArrayLike<number>;
}

export function solidOf(faces: Faces): SolidShape {
  const { vertices, facets, flat } = faces;
  return { vertices, facets, ends: flat["edges.ends"] ?? faces.edges.flatMap((edge) => edge.ends) };
}

const NOTHING: SolidShape = { vertices: [], facets: [], ends: [] };

/** The origin and the ends of the axes. */
const CORNERS: readonly Vec3[] = [
  [0, 0, 0],
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
];

/** Red, green and blue of colours that were drawn before. */
const KNOWN = new Map<string, Vec3>();

function colourOf(text: string): Vec3 {
  const known = KNOWN.get(text) ?? (new Color(text).toArray() as [number, number, number]);
  KNOWN.set(text, known);
  return known;
}

export class Solid {
  readonly objects: readonly Object3D[];
  look: SolidLook = { facets: [], opacity: 1, edge: "#000000" };
  private drawn: SolidShape = NOTHING;
  private source: object | null = null;
  private placing: ((point: Vec3) => Vec3) | null = null;
  private readonly faces: Mesh<BufferGeometry, MeshLambertMaterial>;
  private readonly lines: LineSegments<BufferGeometry, LineBasicMaterial>;

  constructor() {
    // Faces are moved back a little, so that the edges on them do not flicker.
    const material = new MeshLambertMaterial({
      vertexColors: true,
      polygonOffset: true,
      polygonOffsetFactor: 1,
      polygonOffsetUnits: 1,
    });
    this.faces = new Mesh(new BufferGeometry(), material);
    this.lines = new LineSegments(new BufferGeometry(), new LineBasicMaterial());
    this.objects = [this.faces, this.lines];
    for (const object of this.objects) object.matrixAutoUpdate = false;
  }

  /** The shape in its place. */
  get shape(): SolidShape {
    const { drawn, placing } = this;
    return placing ? { ...drawn, vertices: drawn.vertices.map(placing) } : drawn;
  }

  /** Draws nothing. */
  clear(): void {
    this.draw(NOTHING, { facets: [], opacity: 1, edge: "#000000" });
  }

  /** Moves what is drawn, by a movement of space: nothing is made anew. */
  place(movement: (point: Vec3) => Vec3): void {
    this.placing = movement;
    const [o, x, y, z] = CORNERS.map(movement) as [Vec3, Vec3, Vec3, Vec3];
    const [a, b, c] = [sub3(x, o), sub3(y, o), sub3(z, o)];
    const matrix = new Matrix4(a[0], b[0], c[0], o[0], a[1], b[1], c[1], o[1], a[2], b[2], c[2], o[2], 0, 0, 0, 1);
    for (const object of this.objects) {
      object.matrix.copy(matrix);
      object.matrixWorldNeedsUpdate = true;
    }
  }

  /** Draws what comes of a source, unless it was drawn last. */
  drawFrom(source: object, make: () => readonly [SolidShape, SolidLook]): void {
    if (this.source === source) return;
    this.draw(...make());
    this.source = source;
  }

  draw(shape: SolidShape, look: SolidLook): void {
    [this.drawn, this.look, this.source] = [shape, look, null];
    const corners = shape.facets.reduce((sum, facet) => sum + Math.max(0, facet.length - 2) * 3, 0);
    const places = new Float32Array(corners * 3);
    const normals = new Float32Array(corners * 3);
    const colours = new Float32Array(corners * 3);
    let at = 0;
    shape.facets.forEach((facet, index) => {
      const [red, green, blue] = colourOf(look.facets[index] ?? "#888888");
      const normal = normalOf(shape, facet);
      for (let corner = 2; corner < facet.length; corner += 1) {
        for (const vertex of [facet[0], facet[corner - 1], facet[corner]]) {
          const place = shape.vertices[vertex as number] as Vec3;
          for (let axis = 0; axis < 3; axis += 1) {
            places[at + axis] = place[axis] as number;
            normals[at + axis] = normal[axis] as number;
          }
          [colours[at], colours[at + 1], colours[at + 2]] = [red, green, blue];
          at += 3;
        }
      }
    });
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(places, 3));
    geometry.setAttribute("normal", new BufferAttribute(normals, 3));
    geometry.setAttribute("color", new BufferAttribute(colours, 3));
    this.faces.geometry.dispose();
    this.faces.geometry = geometry;
    this.faces.material.transparent = look.opacity < 1;
    this.faces.material.opacity = look.opacity;
    this.faces.material.depthWrite = look.opacity === 1;
    // A transparent facet in the plane of an opaque one lies before it, behind its edges.
    const back = look.opacity < 1 ? 0.5 : 1;
    [this.faces.material.polygonOffsetFactor, this.faces.material.polygonOffsetUnits] = [back, back];
    // Of an opaque solid nobody sees the inside; a flat one has no inside.
    this.faces.material.side =
      look.opacity === 1 && shape.facets.length > 2 && !look.isTwoSided ? FrontSide : DoubleSide;
    const ends = new Float32Array(shape.ends.length * 3);
    for (let end = 0; end < shape.ends.length; end += 1)
      ends.set(shape.vertices[shape.ends[end] as number] as Vec3, 3 * end);
    const segments = new BufferGeometry();
    segments.setAttribute("position", new BufferAttribute(ends, 3));
    this.lines.geometry.dispose();
    this.lines.geometry = segments;
    this.lines.material.color.set(look.edge);
  }
}

/** The unit normal of a facet, outward; zero for a facet without area. */
export function normalOf(shape: SolidShape, facet: readonly number[]): Vec3 {
  const at = (place: number): Vec3 => shape.vertices[facet[place] as number] as Vec3;
  if (facet.length < 3) return [0, 0, 0];
  const normal = cross3(sub3(at(1), at(0)), sub3(at(2), at(0)));
  const size = length3(normal);
  return size > 0 ? scale3(normal, 1 / size) : normal;
}

/** The facet that is seen at a pixel: of a convex solid, that which faces the reader there. */
export function pickFacet(solid: Solid, pixelOf: (place: Vec3) => Vec2, gaze: Vec3, pixel: Vec2): number | null {
  const { shape } = solid;
  const seen = shape.vertices.map(pixelOf);
  const found = shape.facets.findIndex((facet) => {
    if (facet.length < 3 || dot3(normalOf(shape, facet), gaze) >= 0) return false;
    const corners = facet.map((vertex) => seen[vertex] as Vec2);
    const turns = corners.map(([x, y], place) => {
      const [u, v] = corners[(place + 1) % corners.length] as Vec2;
      return (u - x) * (pixel[1] - y) - (v - y) * (pixel[0] - x);
    });
    return turns.every((turn) => turn <= 0) || turns.every((turn) => turn >= 0);
  });
  return found < 0 ? null : found;
}
