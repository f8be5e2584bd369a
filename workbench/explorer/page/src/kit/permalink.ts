/** The state in the address: what a teacher sends, and what a reload brings back. */

export interface Told {
  readonly chapter: string;
  readonly state: unknown;
}

export function address(chapter: string, state: unknown): string {
  return `#${chapter}?${encodeURIComponent(JSON.stringify(state))}`;
}

/** The chapter and the state that an address tells; null for the parts that it does not. */
export function readAddress(hash: string): Told | null {
  const [chapter, state] = hash.replace(/^#/, "").split("?", 2);
  if (!chapter) return null;
  try {
    return { chapter, state: state === undefined ? null : JSON.parse(decodeURIComponent(state)) };
  } catch {
    return { chapter, state: null };
  }
}

/** Puts the state into the address without a new entry in the history: going back leads to the chapter before. */
export function tell(chapter: string, state: unknown): void {
  history.replaceState(null, "", address(chapter, state));
}
