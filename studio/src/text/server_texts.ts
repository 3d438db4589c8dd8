/// The texts that the server had, by their versions. The text of another window says from which one it
/// was made, so that what was changed here meanwhile can be merged with it.

const kMost = 64;  // of one file

interface Version {
    v: number;
    text: string;
}

const kept = new Map<string, Version[]>();

/// Takes note of a text that came from the server, or that this page sent to be version `v`.
export function noteText(file: string, v: number, text: string): void {
    const others = (kept.get(file) ?? []).filter((one) => one.v !== v);
    kept.set(file, [...others, { v, text }].sort((a, b) => a.v - b.v).slice(-kMost));
}

/// The text of a file when the server was at a version; null if it is not known.
export function textAt(file: string, v: number): string | null {
    return kept.get(file)?.findLast((one) => one.v <= v)?.text ?? null;
}

export function forgetTexts(): void {
    kept.clear();
}
