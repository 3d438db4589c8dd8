/// Names of new files, as the start page suggests and checks them.

/// What is wrong with a name of a new shot, as a sentence; empty: nothing.
export function problemOfName(name: string): string {
    const last = name.trim().split('/').pop() ?? '';
    if (name.trim() === '') {
        return 'Give the new shot a name.';
    }
    if (last === '' || last.startsWith('.')) {
        return 'A name may neither be empty nor start with a dot.';
    }
    if (/[\u0000-\u001f\u007f\\:*?"<>|]/.test(name)) {
        return 'A name may not have any of \\ : * ? " < > |';
    }
    return name.length > 200 ? 'This name is too long.' : '';
}

/// The file's name: ".yaml" is added.
export function fileOfName(name: string): string {
    const trimmed = name.trim();
    return /\.ya?ml$/.test(trimmed) ? trimmed : `${trimmed}.yaml`;
}

/// A name that is not taken: "break", "break_2" ...
export function freeName(name: string, taken: readonly string[]): string {
    const stem = name.replace(/\.ya?ml$/, '');
    for (let i = 1; ; i += 1) {
        const free = i === 1 ? stem : `${stem}_${i}`;
        if (!taken.includes(`${free}.yaml`)) {
            return free;
        }
    }
}

/// "nine_ball_break" in words: "Nine ball break".
export function titleOf(name: string): string {
    const words = name.replaceAll('_', ' ');
    return words.charAt(0).toUpperCase() + words.slice(1);
}
