/** The library in the page: in the main thread for what a drag asks, in a worker for what takes longer. */

import { folded } from "./columns";
import { Machine, Stopped, textOf } from "./machine";
import {
  lineOf,
  readAnswer,
  readVerdict,
  refuse,
  type Answer,
  type AsksHeld,
  type HeldEntry,
  type Question,
  type Verdict,
} from "./questions";
import type { Report } from "./worker";

interface Waiting {
  resolve(bytes: Uint8Array): void;
  reject(failure: Error): void;
}

export class Engine implements AsksHeld {
  private worker: Worker | null = null;
  private readonly waiting = new Map<number, Waiting>();
  private errands = 0;
  /** The input of the body that the machine holds. */
  private held: unknown = null;

  private constructor(
    private readonly module: WebAssembly.Module,
    private readonly machine: Machine,
    private readonly workerScript: string,
  ) {}

  static async open(module: WebAssembly.Module, workerScript: string): Promise<Engine> {
    return new Engine(module, await Machine.open(module), workerScript);
  }

  /** Answers at once, in this thread. Throws a `Refusal` for a question that the library refuses. */
  ask = <Result>(question: Question<Result>): Answer<Result> => {
    const line = lineOf(question);
    return this.read(question, line, this.machine.call(question.entry, [line]));
  };

  /** Answers in the worker. */
  askLater = async <Result>(question: Question<Result>): Promise<Answer<Result>> => {
    const line = lineOf(question);
    return this.read(question, line, await this.send(question.entry, line));
  };

  /**
   * What an entry leaves for a point and a body, at once. The body is read where it is another than that of the call
   * before, so that a drag of the point among very many generators reads nothing.
   */
  askHeld = <Result>(entry: HeldEntry, body: Question<never>, point: readonly [number, number, number]): Result => {
    try {
      if (this.held !== body.input) {
        const refused = textOf(this.machine.call("hold", [lineOf(body)]));
        if (refused !== "") refuse(refused);
        this.held = body.input;
      }
      const bytes = this.machine.call(entry, point);
      return entry === "rival" ? (JSON.parse(textOf(bytes)) as Result) : folded<Result>(bytes);
    } catch (failure) {
      this.held = null;
      throw failure;
    }
  };

  /** Lets the verifier check an answer, at once. */
  verify = (answer: Answer<unknown>): Verdict =>
    readVerdict(textOf(this.machine.call("verify", [answer.question, answer.answer])));

  /** Lets the verifier check an answer in the worker. */
  verifyLater = async (answer: Answer<unknown>): Promise<Verdict> =>
    readVerdict(textOf(await this.send("verify", answer.question, answer.answer)));

  private read<Result>(question: Question<Result>, line: string, bytes: Uint8Array): Answer<Result> {
    if (question.entry === "answer") return readAnswer<Result>(line, textOf(bytes));
    return { question: line, answer: "", result: folded<Result>(bytes) };
  }

  private send(entry: string, ...texts: string[]): Promise<Uint8Array> {
    const number = ++this.errands;
    return new Promise((resolve, reject) => {
      this.waiting.set(number, { resolve, reject });
      this.begun().postMessage({ number, entry, texts });
    });
  }

  /** The worker, made from the page's own text: a page opened from a file can load no other script. */
  private begun(): Worker {
    if (this.worker) return this.worker;
    const place = URL.createObjectURL(new Blob([this.workerScript], { type: "text/javascript" }));
    const worker = new Worker(place);
    worker.onmessage = (event: MessageEvent<Report>) => {
      const waiting = this.waiting.get(event.data.number);
      this.waiting.delete(event.data.number);
      if (!waiting) return;
      if ("bytes" in event.data) waiting.resolve(event.data.bytes);
      else waiting.reject(new Stopped(event.data.failure));
    };
    worker.postMessage(this.module);
    this.worker = worker;
    return worker;
  }
}
