/** A convex solid as it is drawn: facets with colours, and edges above them. */

import {
  BufferAttribute,
  BufferGeometry,
  Color,
  DoubleSide,
  LineBasicMaterial,
  LineSegments,
  Mesh,
  MeshLambertMaterial,
  type Object3D,
} from "three";
import type { Vec2, Vec3 } from "../library/shapes";
import { cross3, dot3, length3, scale3, sub3 } from "./vectors";

export interface SolidLook {
  /** The colour of each facet, as #rrggbb. */
  readonly facets: readonly string[];
  readonly opacity: number;
  /** The colour of the edges. */
  readonly edge: string;
}

export interface SolidShape {
  readonly vertices: readonly Vec3[];
  /** The vertices of each facet, counter-clockwise from outside. */
  readonly facets: readonly (readonly number[])[];
  readonly edges: readonly (readonly [number, number])[];
}

export class Solid {
  readonly objects: readonly Object3D[];
  shape: SolidShape = { vertices: [], facets: [], edges: [] };
  look: SolidLook = { facets: [], opacity: 1, edge: "#000000" };
  private readonly faces: Mesh<BufferGeometry, MeshLambertMaterial>;
  private readonly lines: LineSegments<BufferGeometry, LineBasicMaterial>;

  constructor() {
    // Faces are moved back a little, so that the edges on them do not flicker.
    const material = new MeshLambertMaterial({
      vertexColors: true,
      side: DoubleSide,
      polygonOffset: true,
      polygonOffsetFactor: 1,
      polygonOffsetUnits: 1,
    });
    this.faces = new Mesh(new BufferGeometry(), material);
    this.lines = new LineSegments(new BufferGeometry(), new LineBasicMaterial());
    this.objects = [this.faces, this.lines];
  }

  /** Draws nothing. */
  clear(): void {
    this.draw({ vertices: [], facets: [], edges: [] }, { facets: [], opacity: 1, edge: "#000000" });
  }

  draw(shape: SolidShape, look: SolidLook): void {
    [this.shape, this.look] = [shape, look];
    const corners = shape.facets.reduce((sum, facet) => sum + Math.max(0, facet.length - 2) * 3, 0);
    const places = new Float32Array(corners * 3);
    const normals = new Float32Array(corners * 3);
    const colours = new Float32Array(corners * 3);
    let at = 0;
    shape.facets.forEach((facet, index) => {
      const colour = new Color(look.facets[index] ?? "#888888");
      const normal = normalOf(shape, facet);
      for (let corner = 2; corner < facet.length; corner += 1) {
        for (const vertex of [facet[0], facet[corner - 1], facet[corner]]) {
          places.set(shape.vertices[vertex as number] as Vec3, at);
          normals.set(normal, at);
          colours.set([colour.r, colour.g, colour.b], at);
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
    const ends = new Float32Array(
      shape.edges.flatMap((edge) => edge.flatMap((vertex) => [...(shape.vertices[vertex] as Vec3)])),
    );
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
