/** The state of a chapter, its past and its future. */

export class Store<State> {
  private past: State[] = [];
  private future: State[] = [];
  private rested: State;

  constructor(
    private now: State,
    private readonly changed: (finished: boolean) => void,
  ) {
    this.rested = now;
  }

  get state(): State {
    return this.now;
  }

  get canUndo(): boolean {
    return this.past.length > 0;
  }

  get canRedo(): boolean {
    return this.future.length > 0;
  }

  change(state: State): void {
    this.now = state;
    this.changed(false);
  }

  commit(state: State): void {
    this.now = state;
    if (state !== this.rested) {
      this.past.push(this.rested);
      if (this.past.length > UNDO_LIMIT) this.past.shift();
      this.future = [];
      this.rested = state;
    }
    this.changed(true);
  }

  undo(): void {
    this.go(this.past, this.future);
  }

  redo(): void {
    this.go(this.future, this.past);
  }

  private go(from: State[], to: State[]): void {
    const state = from.pop();
    if (state === undefined) return;
    to.push(this.rested);
    this.now = this.rested = state;
    this.changed(true);
  }
}

/** Changes that can be undone. */
const UNDO_LIMIT = 200;
