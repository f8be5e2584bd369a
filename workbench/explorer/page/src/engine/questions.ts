/** Questions to the library and their answers, before anybody knows who carries them. */

/** A question; the type of its answer's result goes with it. */
export interface Question<Result> {
  /** The entry of the module that answers: a question of `solve`, or one for a picture. */
  readonly entry: "answer" | "picture";
  readonly kind: string;
  readonly input: unknown;
  readonly method?: string;
  /** Never present: it only ties the question to the type of its result. */
  readonly result?: Result;
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
  constructor(readonly code: string, message: string) {
    super(message);
  }
}

/** The line of JSON of a question, as `zonobench solve` reads it. */
export function lineOf(question: Question<unknown>): string {
  const { kind, input, method } = question;
  const id = "page";
  return JSON.stringify(method === undefined ? { id, kind, input } : { id, kind, input, method });
}

/** The answer in a line of JSON. */
export function readAnswer<Result>(question: string, answer: string): Answer<Result> {
  const read = JSON.parse(answer) as { result?: Result; error?: { code: string; message: string } };
  if (read.error) throw new Refusal(read.error.code, read.error.message);
  return { result: read.result as Result, question, answer };
}

/** The verdict in the text that the entry `verify` leaves: the word, then a line with the reason. */
export function readVerdict(text: string): Verdict {
  const [verdict, ...reason] = text.split("\n");
  return { verdict: verdict as Verdict["verdict"], reason: reason.join("\n") };
}
