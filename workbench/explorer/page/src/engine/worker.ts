/** The worker: a machine of its own, for what takes longer than a frame. */

import { Machine } from "./machine";

export interface Errand {
  readonly number: number;
  readonly entry: string;
  readonly texts: string[];
}

export type Report = { readonly number: number } & (
  | { readonly bytes: Uint8Array<ArrayBuffer> }
  | { readonly failure: string }
);

let machine: Promise<Machine> | null = null;

self.onmessage = async (event: MessageEvent<WebAssembly.Module | Errand>) => {
  if (event.data instanceof WebAssembly.Module) {
    machine = Machine.open(event.data);
    return;
  }
  const { number, entry, texts } = event.data;
  let report: Report;
  try {
    report = { number, bytes: (await (machine as Promise<Machine>)).call(entry, texts) };
  } catch (failure) {
    report = { number, failure: String(failure instanceof Error ? failure.message : failure) };
  }
  self.postMessage(report, { transfer: "bytes" in report ? [report.bytes.buffer] : [] });
};
