/** Numbers as people write them: with a point or a comma, with any minus, as a quotient. */

/** What a number is written like; a hint where one could not be read. */
export const NUMBER_HINT = "Write a number, such as 1.5 or 3/2.";

const DECIMAL = "[+-]?(?:\\d+\\.?\\d*|\\.\\d+)(?:e[+-]?\\d+)?";
const NUMBER = new RegExp(`^(${DECIMAL})(?:/(${DECIMAL}))?$`, "i");

/** The number that a text writes, or null where it writes none, or one that is not finite. */
export function readNumber(text: string): number | null {
  const plain = text.replace(/\s+(?=\/)|(?<=\/)\s+/g, "").trim();
  const parts = NUMBER.exec(plain.replaceAll(",", ".").replaceAll("−", "-"));
  if (!parts) return null;
  const value = Number(parts[1]) / Number(parts[2] ?? 1);
  return Number.isFinite(value) ? value : null;
}
