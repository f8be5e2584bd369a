/**
 * The module of the library as a machine: text or numbers go in, bytes come out. Nothing above this file knows that
 * there is a memory, and nothing but this file calls an entry of the module.
 *
 * A panic of the library traps the machine. Its message is read, the machine is thrown away, and the next call begins
 * with a new one, because a value that was borrowed when the trap came stays borrowed.
 */

interface Entries {
  memory: WebAssembly.Memory;
  input(bytes: number): number;
  output(): number;
  failure(): number;
  [entry: string]: unknown;
}

/** The library stopped in the middle of a call; the message is that of its panic. */
export class Stopped extends Error {}

export class Machine {
  private constructor(
    private readonly module: WebAssembly.Module,
    private entries: Entries | null,
  ) {}

  /** A large module can be made ready only in the background: browsers refuse to do it in the midst of a script. */
  static async open(module: WebAssembly.Module): Promise<Machine> {
    return new Machine(module, await begun(module));
  }

  /**
   * Calls an entry with what it takes: texts, which are put into the buffer one directly after the other, or numbers.
   * Returns a copy of the bytes that it leaves.
   */
  call(entry: string, taken: readonly string[] | readonly number[]): Uint8Array<ArrayBuffer> {
    const { entries } = this;
    if (!entries) throw new Stopped("the library begins anew after it stopped; try again");
    const run = entries[entry];
    if (typeof run !== "function") throw new Stopped(`the module has no entry ${entry}`);
    try {
      const numbers = taken.map((one) => (typeof one === "number" ? one : null));
      const given = numbers.includes(null) ? [put(entries, taken as readonly string[])] : numbers;
      return bytesOf(entries, run(...given) as number);
    } catch (trap) {
      this.entries = null;
      void begun(this.module).then((next) => (this.entries = next));
      if (!(trap instanceof WebAssembly.RuntimeError)) throw trap;
      throw new Stopped(textOf(bytesOf(entries, entries.failure())) || trap.message);
    }
  }
}

/** Puts texts into the buffer; returns the length of the first. */
function put(entries: Entries, texts: readonly string[]): number {
  const encoder = new TextEncoder();
  const parts = texts.map((text) => encoder.encode(text));
  let start = entries.input(parts.reduce((sum, part) => sum + part.length, 0));
  for (const part of parts) {
    new Uint8Array(entries.memory.buffer, start, part.length).set(part);
    start += part.length;
  }
  return parts[0]?.length ?? 0;
}

async function begun(module: WebAssembly.Module): Promise<Entries> {
  return (await WebAssembly.instantiate(module)).exports as Entries;
}

function bytesOf(entries: Entries, length: number): Uint8Array<ArrayBuffer> {
  return new Uint8Array(entries.memory.buffer, entries.output(), length).slice() as Uint8Array<ArrayBuffer>;
}

export function textOf(bytes: Uint8Array): string {
  return new TextDecoder().decode(bytes);
}
