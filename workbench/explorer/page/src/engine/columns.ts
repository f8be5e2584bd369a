/** Answers whose tables come as bytes behind a line of JSON, put together again. */

import { textOf } from "./machine";
import { refuse } from "./questions";

interface Told {
  readonly result: Record<string, unknown>;
  readonly tables: readonly {
    /** The field of the result, and for a list of objects the field of each. */
    readonly at: readonly [string, string?];
    /** The width of its rows: 0 for numbers that stand by themselves, null for rows of their own length. */
    readonly width: number | null;
    /** The type and the bytes of each column; rows of their own length have their ends in the first. */
    readonly columns: readonly (readonly ["f64" | "u32", number])[];
  }[];
  readonly error?: unknown;
}

const NOTHING = new Uint32Array();

/** The index that stands for none. */
const NONE = 0xffffffff;

const LINE_END = 10;

/**
 * The result of an answer. Throws the refusal that it may be instead. Rows and objects are made of a table when they are
 * first asked for, since thousands of them cost more than the answer; `flat` has the columns as they came, by field.
 */
export function folded<Result>(bytes: Uint8Array): Result {
  let at = bytes.indexOf(LINE_END) + 1;
  const line = textOf(bytes.subarray(0, at));
  const { result, tables, error } = JSON.parse(line) as Told;
  if (error) refuse(line);
  const flat: Record<string, Numbers> = {};
  for (const table of tables) {
    const [first = NOTHING, all = NOTHING] = table.columns.map(([of, length]) => {
      const begin = bytes.byteOffset + at;
      at += length;
      return of === "f64"
        ? new Float64Array(bytes.buffer, begin, length / 8)
        : new Uint32Array(bytes.buffer, begin, length / 4);
    });
    const [name, field] = table.at;
    flat[table.at.join(".")] = first;
    const rows = () => (table.width === null ? rowsOf(first, all) : inRows(first, table.width));
    const before = Object.getOwnPropertyDescriptor(result, name);
    whenAsked(result, name, () => {
      if (field === undefined) return rows();
      const values = rows();
      const objects = (before?.get?.() ?? before?.value ?? values.map(() => ({}))) as Record<string, unknown>[];
      for (let index = 0; index < values.length; index += 1)
        (objects[index] as Record<string, unknown>)[field] = values[index];
      return objects;
    });
  }
  return Object.defineProperty(result, "flat", { value: flat }) as Result;
}

/** A field whose value is made when it is first read. */
function whenAsked(result: object, name: string, make: () => unknown): void {
  let value: unknown;
  const get = () => (value ??= make());
  Object.defineProperty(result, name, { get, enumerable: true, configurable: true });
}

type Numbers = Float64Array | Uint32Array;

/** Entries of a column: floats as they are, of indices one that stands for none as null. */
function part(numbers: Numbers, begin: number, end: number): unknown[] {
  const entries: unknown[] = new Array(end - begin);
  if (numbers instanceof Float64Array) {
    for (let at = begin; at < end; at += 1) entries[at - begin] = numbers[at];
  } else {
    for (let at = begin; at < end; at += 1) entries[at - begin] = numbers[at] === NONE ? null : numbers[at];
  }
  return entries;
}

function inRows(numbers: Numbers, width: number): unknown[] {
  if (width === 0) return part(numbers, 0, numbers.length);
  const rows: unknown[] = new Array(numbers.length / width);
  for (let row = 0; row < rows.length; row += 1) rows[row] = part(numbers, row * width, (row + 1) * width);
  return rows;
}

function rowsOf(ends: Numbers, all: Numbers): unknown[] {
  const rows: unknown[] = new Array(ends.length);
  let begin = 0;
  for (let row = 0; row < ends.length; row += 1) {
    const end = ends[row] as number;
    rows[row] = part(all, begin, end);
    begin = end;
  }
  return rows;
}
