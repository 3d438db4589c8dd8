/// Times as the strip and the clocks write them.

/// "01:02.75": minutes, seconds, hundredths of film time.
export function filmClock(seconds: number): string {
    const hundredths = Math.round(seconds * 100);
    const minutes = Math.floor(hundredths / 6000);
    const rest = ((hundredths - 6000 * minutes) / 100).toFixed(2).padStart(5, '0');
    return `${String(minutes).padStart(2, '0')}:${rest}`;
}

/// "1.234 s" of scene time.
export function sceneClock(seconds: number): string {
    return `${seconds.toFixed(3)} s`;
}

/// A speed as people say it: "1×", "1/8×", "−2×", "0.37×".
export function speedText(speed: number): string {
    const size = Math.abs(speed);
    const sign = speed < 0 ? '−' : '';
    const inverse = 1 / size;
    if (size < 1e-9) {
        return '0×';
    }
    if (size < 1 && Math.abs(inverse - Math.round(inverse)) < 0.005 * inverse) {
        return `${sign}1/${Math.round(inverse)}×`;
    }
    return `${sign}${Number(size.toPrecision(2))}×`;
}
