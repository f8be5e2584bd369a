// Every line of a file of questions is answered by the module and by the program: the same bytes are expected, and a
// verdict that is not `wrong`.
//
//     node check.mjs MODULE.wasm PROGRAM QUESTIONS.jsonl

import { execFileSync } from "node:child_process";
import { readFileSync } from "node:fs";

const [modulePath, program, questionsPath] = process.argv.slice(2);
const { instance } = await WebAssembly.instantiate(readFileSync(modulePath), {});
const { memory, input, output, answer, verify } = instance.exports;

function put(text) {
  const bytes = new TextEncoder().encode(text);
  const start = input(bytes.length);
  new Uint8Array(memory.buffer, start, bytes.length).set(bytes);
}

function take(length) {
  return new TextDecoder().decode(new Uint8Array(memory.buffer, output(), length));
}

const questions = readFileSync(questionsPath, "utf8").split("\n").filter((line) => line.trim() !== "");
// The program refuses some of the questions, for which it exits with a failure after it has answered all of them.
let expected;
try {
  expected = execFileSync(program, ["solve", questionsPath], { encoding: "utf8", maxBuffer: 2 ** 30, stdio: "pipe" });
} catch (failure) {
  expected = failure.stdout;
}
const answers = expected.split("\n").filter((line) => line !== "");
if (answers.length !== questions.length) {
  throw new Error(`${questions.length} questions, ${answers.length} answers of the program`);
}
const verdicts = { right: 0, wrong: 0, unchecked: 0 };
let different = 0;
questions.forEach((question, index) => {
  put(question);
  const given = take(answer());
  if (given !== answers[index]) {
    different += 1;
    console.log(`line ${index + 1}:\n  module  ${given.slice(0, 200)}\n  program ${answers[index].slice(0, 200)}`);
  }
  put(question + given);
  const [verdict, reason] = take(verify(new TextEncoder().encode(question).length)).split("\n");
  verdicts[verdict] += 1;
  if (verdict === "wrong") console.log(`line ${index + 1}: wrong: ${reason}`);
});
console.log(`${questions.length} questions, ${different} answers differ, verdicts ${JSON.stringify(verdicts)}`);
process.exit(different + verdicts.wrong === 0 ? 0 : 1);
