/** What is asked. All members may be left out. */
export interface Options {
  /** The motion that the history must describe: the one that it records (default), or that of the scene. */
  truth?: "recorded" | "exact";
  /** How far a claimed time may be off, in units of time: a decimal, a fraction "p/q" or a number; default "1e-6". */
  tolerance?: string | number;
  /** How far velocities may be off, relative to the speeds that meet; default "1e-9". */
  lawTolerance?: string | number;
  /** Refutes claims out of order, quadruplets without orientation and another horizon than the scene's. */
  strict?: boolean;
  /** Accepts quadruplets whose third generators are exchanged. */
  unoriented?: boolean;
  /** Told now and then which rule is at work, at which claim of how many. */
  progress?: (rule: string, claim: number, of: number) => void;
}

/** What the kernel says, as the program voroproof-kernel does. */
export interface Answer {
  verdict: "CERTIFIED" | "REFUTED" | "UNDECIDED" | "INVALID";
  /** Why it is not CERTIFIED; else empty. */
  reason: string;
  /** The line of the history that the verdict is about; 0 where it is about none. */
  line: number;
  /** Whether no earlier line is wrong. */
  isFirst: boolean;
  /** Of claims, of what was proved, and of each leniency. */
  counts: Record<string, number>;
  /** All lines that the program prints. */
  lines: string;
  /** Up to when the history goes; null where it could not be read. */
  horizon: number | null;
  /** Where that is not the scene's horizon: what is so. */
  horizonNote: string;
}

/**
 * Proves or refutes a history of a scene, both the bytes or the text of a file. Each call has a memory of its own. It
 * rejects with a TypeError for options that are none, and with an Error where there is no memory left.
 */
export function certify(scene: Uint8Array | string, history: Uint8Array | string, options?: Options): Promise<Answer>;
