/** Opens the engine from the module of WebAssembly that is written into the page. */

import { unpackedElement } from "../unpack/element";
import { Engine } from "./engine";

/** The script of the worker, bundled into the page's own. */
declare const WORKER_SCRIPT: string;

export async function openEngine(): Promise<Engine> {
  return Engine.open(await WebAssembly.compile(unpackedElement("module")), WORKER_SCRIPT);
}
