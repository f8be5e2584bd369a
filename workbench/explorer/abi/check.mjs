// Every line of a file of questions is answered by the module and by the program: the same bytes are expected, and a
// verdict that is not `wrong`. The module leaves out what the page has no use for, which is counted: questions that are
// neither of the plane nor of space, and methods that need an engine for linear programs. It takes one line at a time,
// so a complaint about JSON names line 1.
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
/** Whether the module says that it leaves out what is asked. */
function isLeftOut(answer) {
  const { code, message } = JSON.parse(answer).error ?? {};
  return (code === "dimension_mismatch" && message.includes("; 2 to 3 are taken")) || code === "unknown_method";
}

const verdicts = { right: 0, wrong: 0, unchecked: 0 };
let [same, different, leftOut] = [0, 0, 0];
questions.forEach((question, index) => {
  put(question);
  const given = take(answer());
  const elsewhere = answers[index].replace(`"line ${index + 1},`, '"line 1,').replace(`"line":${index + 1}}`, '"line":1}');
  if (given === elsewhere) same += 1;
  else if (isLeftOut(given)) leftOut += 1;
  else {
    different += 1;
    console.log(`line ${index + 1}:\n  module  ${given.slice(0, 200)}\n  program ${answers[index].slice(0, 200)}`);
  }
  put(question + given);
  const [verdict, reason] = take(verify(new TextEncoder().encode(question).length)).split("\n");
  verdicts[verdict] += 1;
  if (verdict === "wrong") console.log(`line ${index + 1}: wrong: ${reason}`);
});
console.log(`${questions.length} questions: ${same} answers are the same bytes, ${different} differ, ${leftOut} are left out`);
console.log(`verdicts on the module's answers: ${JSON.stringify(verdicts)}`);
process.exit(different + verdicts.wrong === 0 && 2 * same > questions.length ? 0 : 1);
