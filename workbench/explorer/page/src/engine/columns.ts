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

/** The index that stands for none. */
const NONE = 0xffffffff;

const LINE_END = 10;

/** The result of an answer. Throws the refusal that it may be instead. */
export function folded<Result>(bytes: Uint8Array): Result {
  let at = bytes.indexOf(LINE_END) + 1;
  const line = textOf(bytes.subarray(0, at));
  const { result, tables, error } = JSON.parse(line) as Told;
  if (error) refuse(line);
  for (const table of tables) {
    const columns = table.columns.map(([of, length]) => {
      const begin = bytes.byteOffset + at;
      at += length;
      return of === "f64"
        ? new Float64Array(bytes.buffer, begin, length / 8)
        : new Uint32Array(bytes.buffer, begin, length / 4);
    });
    const [first = [], all = []] = columns;
    const rows = table.width === null ? rowsOf(first, all) : inRows(first, table.width);
    const [name, field] = table.at;
    if (field === undefined) {
      result[name] = rows;
      continue;
    }
    const objects = (result[name] ??= rows.map(() => ({}))) as Record<string, unknown>[];
    for (let index = 0; index < rows.length; index += 1)
      (objects[index] as Record<string, unknown>)[field] = rows[index];
  }
  return result as Result;
}

type Numbers = ArrayLike<number>;

/** How an entry of a column is read: floats as they are, of indices one that stands for none as null. */
function reader(numbers: Numbers): (value: number | undefined) => unknown {
  return numbers instanceof Uint32Array ? (value) => (value === NONE ? null : value) : (value) => value;
}

function inRows(numbers: Numbers, width: number): unknown[] {
  const present = reader(numbers);
  if (width === 0) return Array.from(numbers, present);
  const rows: unknown[] = new Array(numbers.length / width);
  for (let row = 0; row < rows.length; row += 1) {
    const entries: unknown[] = new Array(width);
    for (let entry = 0; entry < width; entry += 1) entries[entry] = present(numbers[row * width + entry]);
    rows[row] = entries;
  }
  return rows;
}

function rowsOf(ends: Numbers, all: Numbers): unknown[] {
  const present = reader(all);
  const rows: unknown[] = new Array(ends.length);
  let begin = 0;
  for (let row = 0; row < ends.length; row += 1) {
    const end = ends[row] as number;
    const entries: unknown[] = new Array(end - begin);
    for (let entry = begin; entry < end; entry += 1) entries[entry - begin] = present(all[entry]);
    rows[row] = entries;
    begin = end;
  }
  return rows;
}
