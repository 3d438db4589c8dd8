/// Numbers of the farm as people read them.
import { durationText } from '../films/durations';

/// "0.3 s", "34 s", "12 min 5 s", "1 h 20 min".
export function secondsText(seconds: number): string {
    return seconds < 10 ? `${seconds.toFixed(1)} s` : durationText(seconds);
}

/// "512 MB", "1.4 GB".
export function memoryText(bytes: number): string {
    return bytes < 1e9 ? `${Math.round(bytes / 1e6)} MB` : `${(bytes / 1e9).toFixed(1)} GB`;
}

/// "1,440"
export function countText(count: number): string {
    return Math.round(count).toLocaleString('en');
}

/// The last part of a path.
export function nameOf(path: string): string {
    return path.slice(path.lastIndexOf('/') + 1);
}

/// "14:05", or with the day if `withDay`.
export function clockText(unixTime: number, withDay = false): string {
    const day: Intl.DateTimeFormatOptions = withDay ? { month: 'short', day: 'numeric' } : {};
    return new Date(1000 * unixTime).toLocaleString(undefined, { ...day, hour: '2-digit', minute: '2-digit', hour12: false });
}
