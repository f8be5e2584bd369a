/** The library in the page: in the main thread for what a drag asks, in a worker for what takes longer. */

import { Machine, Stopped } from "./machine";
import { lineOf, readAnswer, readVerdict, type Answer, type Question, type Verdict } from "./questions";
import type { Report } from "./worker";

interface Waiting {
  resolve(text: string): void;
  reject(failure: Error): void;
}

export class Engine {
  private worker: Worker | null = null;
  private readonly waiting = new Map<number, Waiting>();
  private errands = 0;

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
    return readAnswer<Result>(line, this.machine.call(question.entry, line));
  };

  /** Answers in the worker. */
  askLater = async <Result>(question: Question<Result>): Promise<Answer<Result>> => {
    const line = lineOf(question);
    return readAnswer<Result>(line, await this.send(question.entry, line));
  };

  /** Lets the verifier check an answer, at once. */
  verify = (answer: Answer<unknown>): Verdict =>
    readVerdict(this.machine.call("verify", answer.question, answer.answer));

  /** Lets the verifier check an answer in the worker. */
  verifyLater = async (answer: Answer<unknown>): Promise<Verdict> =>
    readVerdict(await this.send("verify", answer.question, answer.answer));

  private send(entry: string, ...texts: string[]): Promise<string> {
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
      if ("text" in event.data) waiting.resolve(event.data.text);
      else waiting.reject(new Stopped(event.data.failure));
    };
    worker.postMessage(this.module);
    this.worker = worker;
    return worker;
  }
}
