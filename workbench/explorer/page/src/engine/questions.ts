/** Questions to the library and their answers, before anybody knows who carries them. */

/** A question; the type of its answer's result goes with it. */
export interface Question<Result> {
  /** The entry of the module that answers: a question of `solve`, or one for a picture, whose tables come as bytes. */
  readonly entry: "answer" | "columns";
  readonly kind: string;
  readonly input: unknown;
  readonly method?: string;
  /** Never present: it only ties the question to the type of its result. */
  readonly result?: Result;
}

/** The entries about a point and the body that is held. */
export type HeldEntry = "locate" | "rival";

/** Asks about a point and a body that stays while the point moves. */
export interface AsksHeld {
  askHeld<Result>(entry: HeldEntry, body: Question<never>, point: readonly [number, number, number]): Result;
}

export interface Answer<Result> {
  readonly result: Result;
  /** The line of JSON that was asked. */
  readonly question: string;
  /** The line of JSON that was answered. */
  readonly answer: string;
}

/** What the verifier says of an answer; it shares no code with the library that answered. */
export interface Verdict {
  readonly verdict: "right" | "wrong" | "unchecked";
  readonly reason: string;
}

/** A question that the library does not answer, with the place that is at fault. */
export class Refusal extends Error {
  constructor(
    readonly code: string,
    message: string,
  ) {
    super(message);
  }
}

/** The line of JSON of a question, as `zonobench solve` reads it. */
export function lineOf(question: Question<unknown>): string {
  const { kind, input, method } = question;
  const named = method === undefined ? "" : `,"method":${JSON.stringify(method)}`;
  return `{"id":"page","kind":${JSON.stringify(kind)},"input":${written(input)}${named}}`;
}

/** Lists of so many entries are written once: they stay while something else of the question is dragged. */
const LONG = 200;

const WRITTEN = new WeakMap<object, string>();

/** The same text as that of `JSON.stringify`. */
function written(value: unknown): string {
  if (Array.isArray(value)) {
    if (value.length < LONG) return JSON.stringify(value);
    const before = WRITTEN.get(value) ?? JSON.stringify(value);
    WRITTEN.set(value, before);
    return before;
  }
  if (typeof value !== "object" || value === null) return JSON.stringify(value);
  const fields = Object.entries(value).filter(([, field]) => field !== undefined);
  return `{${fields.map(([name, field]) => `${JSON.stringify(name)}:${written(field)}`).join(",")}}`;
}

/** Throws the refusal that is the answer in a line of JSON. */
export function refuse(answer: string): never {
  const { error } = JSON.parse(answer) as { error?: { code: string; message: string } };
  throw new Refusal(error?.code ?? "", error?.message ?? "no reason is told");
}

/** The answer in a line of JSON. */
export function readAnswer<Result>(question: string, answer: string): Answer<Result> {
  const read = JSON.parse(answer) as { result?: Result; error?: object };
  if (read.error) refuse(answer);
  return { result: read.result as Result, question, answer };
}

/** The verdict in the text that the entry `verify` leaves: the word, then a line with the reason. */
export function readVerdict(text: string): Verdict {
  const [verdict, ...reason] = text.split("\n");
  return { verdict: verdict as Verdict["verdict"], reason: reason.join("\n") };
}
