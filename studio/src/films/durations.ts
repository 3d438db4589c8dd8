/// Durations and counts as sentences about long work have them.

/// "8 s", "2 min 5 s", "1 h 20 min".
export function durationText(seconds: number): string {
    const whole = Math.max(0, Math.round(seconds));
    if (whole < 60) {
        return `${whole} s`;
    }
    const minutes = Math.floor(whole / 60);
    return whole < 3600 ? `${minutes} min ${whole % 60} s`
        : `${Math.floor(minutes / 60)} h ${minutes % 60} min`;
}

/// "1 frame", "240 frames".
export function counted(count: number, one: string): string {
    return `${count} ${one}${count === 1 ? '' : 's'}`;
}
