/**
 * Data that a reader pastes or drops, as text: tables of numbers, JSON with points or with a body, GeoJSON, and the
 * vertices of meshes in OBJ, OFF, PLY and STL. The program's command `enclose` reads more, and says more about it.
 */

import type { Vec2, Vec3 } from "../library/shapes";
import type { OwnData } from "./chapter";
import { fields, finite, list, vec3 } from "./reading";

/** Points that the page takes; the program takes more. */
export const MOST_POINTS = 5000;

/** The data of a text, or a sentence that says why there are none. */
export function readOwnData(text: string): OwnData | string {
  const trimmed = text.trim();
  if (trimmed === "") return "There is no text.";
  if (/^[[{]/.test(trimmed)) return ofJson(trimmed);
  if (/^ply\b/.test(trimmed)) return ofRows(plyRows(trimmed));
  if (/^(C|N)*OFF\b/.test(trimmed)) return withMesh(ofRows(offRows(trimmed)), offRows(trimmed), offFaces(trimmed));
  if (/^\s*solid\b/.test(trimmed)) return ofRows(marked(trimmed, "vertex"));
  if (/^v\s/m.test(trimmed)) return withMesh(ofRows(marked(trimmed, "v")), objRows(trimmed), objFaces(trimmed));
  return ofRows(tableRows(trimmed));
}

function ofRows(rows: number[][]): OwnData | string {
  if (rows.length === 0) return "No line of the text holds two or three numbers.";
  if (rows.length > MOST_POINTS)
    return `The page takes ${MOST_POINTS} points, and these are ${rows.length}: the program takes them.`;
  const dimension = rows[0]?.length ?? 0;
  const odd = rows.findIndex((row) => row.length !== dimension);
  if (odd >= 0) return `Row ${odd + 1} has ${rows[odd]?.length} numbers, the first one has ${dimension}.`;
  if (dimension === 2) return { points: rows as unknown as Vec2[] };
  if (dimension === 3) return { points3: rows as unknown as Vec3[] };
  return `A row has ${dimension} numbers; points have two or three.`;
}

function numbers(line: string): number[] {
  const cells = line
    .trim()
    .split(/[\s,;|]+/)
    .filter((cell) => cell !== "");
  const values = cells.map(Number);
  return values.every(Number.isFinite) ? values : [];
}

function tableRows(text: string): number[][] {
  return text
    .split("\n")
    .filter((line) => !/^\s*(#|\/\/|%)/.test(line))
    .map(numbers)
    .filter((row) => row.length > 0);
}

/** What stands behind a mark in the lines that begin with it. */
function linesOf(text: string, mark: string): string[] {
  const lines = text.split("\n").map((line) => line.trim());
  return lines.filter((line) => line.startsWith(`${mark} `)).map((line) => line.slice(mark.length));
}

function marked(text: string, mark: string): number[][] {
  const rows = linesOf(text, mark).map((line) => numbers(line).slice(0, 3));
  return [...new Map(rows.map((row) => [row.join(), row])).values()];
}

function offRows(text: string): number[][] {
  const rows = tableRows(text.replace(/^(C|N)*OFF\s*/, ""));
  return rows.slice(1, 1 + (rows[0]?.[0] ?? 0)).map((row) => row.slice(0, 3));
}

function objRows(text: string): number[][] {
  return linesOf(text, "v").map((line) => numbers(line).slice(0, 3));
}

/** The corners of the faces, from 0; a corner may be told from the end. */
function objFaces(text: string): number[][] {
  const vertices = objRows(text).length;
  const place = (corner: string) => {
    const at = Number(corner.split("/")[0]);
    return at < 0 ? vertices + at : at - 1;
  };
  return linesOf(text, "f").map((line) => line.trim().split(/\s+/).map(place));
}

function offFaces(text: string): number[][] {
  const rows = tableRows(text.replace(/^(C|N)*OFF\s*/, ""));
  const [vertices = 0, faces = 0] = rows[0] ?? [];
  return rows.slice(1 + vertices, 1 + vertices + faces).map((row) => row.slice(1, 1 + (row[0] ?? 0)));
}

/** The points with the mesh that their faces make of them, if the faces name points that are there. */
function withMesh(data: OwnData | string, rows: number[][], faces: number[][]): OwnData | string {
  if (typeof data === "string" || !("points3" in data) || faces.length === 0) return data;
  const isPlace = (at: number) => Number.isInteger(at) && at >= 0 && at < rows.length;
  if (!faces.flat().every(isPlace)) return data;
  const triangles = faces.flatMap(([first = 0, ...others]) =>
    others.slice(1).map((corner, at): Vec3 => [first, others[at] ?? first, corner]),
  );
  return { ...data, mesh: { vertices: rows as unknown as Vec3[], triangles } };
}

function plyRows(text: string): number[][] {
  const [head = "", body = ""] = text.split(/end_header\r?\n/, 2);
  const count = Number(/element vertex (\d+)/.exec(head)?.[1] ?? 0);
  return body
    .split("\n")
    .slice(0, count)
    .map((line) => numbers(line).slice(0, 3));
}

function ofJson(text: string): OwnData | string {
  let told: unknown;
  try {
    told = JSON.parse(text);
  } catch (failure) {
    return `The text is not JSON: ${String(failure)}`;
  }
  const object = fields(told);
  const input = fields(object?.["input"]) ?? object;
  const generators = list(input?.["generators"], vec3, MOST_POINTS);
  if (generators) return { center: vec3(input?.["center"]) ?? [0, 0, 0], generators };
  const rows = jsonRows(input?.["points"] ?? told);
  return rows.length > 0 ? ofRows(rows) : "The JSON has neither points nor generators of space.";
}

/** All positions of a document, however deep: lists of two or three numbers, and objects with x and y. */
function jsonRows(told: unknown): number[][] {
  if (Array.isArray(told)) {
    const row = told.map(finite);
    if (row.length >= 2 && row.length <= 3 && row.every((value) => value !== null)) return [row as number[]];
    return told.flatMap(jsonRows);
  }
  const object = fields(told);
  if (!object) return [];
  const place = [object["x"], object["y"], object["z"]].map(finite).filter((value) => value !== null);
  if (place.length >= 2) return [place as number[]];
  return ["features", "geometry", "geometries", "coordinates", "points"].flatMap((name) =>
    jsonRows(object[name] ?? []),
  );
}
