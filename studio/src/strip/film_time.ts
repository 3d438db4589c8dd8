/// Times of the film as they are written: exactly, because carom compares fractions. Frame 31 at 24
/// frames a second is at 31 / 24 s; at 1.2917 s it would still belong to the camera before.
import { sourceOf, type Change } from '../edit/edit';
import { parseQuantity } from '../edit/quantity';
import type { KeyPath } from '../protocol';

const kMostDecimals = 6; // of a time that is written without a fraction
const kLargest = 1e7; // denominator that is looked for

/// numerator / denominator in lowest terms, denominator > 0; seconds, or frames per second.
export interface Fraction {
    numerator: number;
    denominator: number;
}

function divisorOf(a: number, b: number): number {
    return b === 0 ? Math.abs(a) : divisorOf(b, a % b);
}

export function fraction(numerator: number, denominator: number): Fraction {
    const common = divisorOf(numerator, denominator) || 1;
    return { numerator: numerator / common, denominator: denominator / common };
}

/// The fraction that the server's number stands for: the one with the smallest denominator that
/// gives exactly this double. (Its continued fraction.)
export function fractionOf(value: number): Fraction {
    let [p0, q0, p1, q1] = [1, 0, Math.floor(value), 1];
    let rest = value - Math.floor(value);
    while (p1 / q1 !== value && rest > 0) {
        const whole = Math.floor(1 / rest);
        rest = 1 / rest - whole;
        [p0, q0, p1, q1] = [p1, q1, whole * p1 + p0, whole * q1 + q0];
        if (q1 > kLargest) {
            return fraction(Math.round(value * 1e6), 1e6);
        }
    }
    return { numerator: p1, denominator: q1 };
}

export function sum(a: Fraction, b: Fraction): Fraction {
    const common = divisorOf(a.denominator, b.denominator);
    const [left, right] = [b.denominator / common, a.denominator / common];
    return fraction(a.numerator * left + b.numerator * right, a.denominator * left);
}

export function minus(a: Fraction, b: Fraction): Fraction {
    return sum(a, { numerator: -b.numerator, denominator: b.denominator });
}

export function secondsOf({ numerator, denominator }: Fraction): number {
    return numerator / denominator;
}

/// When a frame of the film begins.
export function timeOfFrame(frame: number, fps: number): Fraction {
    const rate = fractionOf(fps);
    return fraction(frame * rate.denominator, rate.numerator);
}

/// As a decimal number, if it is exactly one with few digits; else null.
function decimal(time: Fraction): string | null {
    const scaled = time.numerator * 10 ** kMostDecimals / time.denominator;
    return Number.isInteger(scaled)
        && scaled * time.denominator === time.numerator * 10 ** kMostDecimals
        ? String(Number((scaled / 10 ** kMostDecimals).toFixed(kMostDecimals))) : null;
}

/// As a fraction with the divisor of an old one, " / 48"; null if it is none of that.
function likeFraction(time: Fraction, divisor: string): string | null {
    const [, sign = '', digits = ''] = /^(\s*\/\s*)(\d+)$/.exec(divisor) ?? [];
    const wanted = Number(digits);
    return wanted > 0 && wanted % time.denominator === 0
        ? `${time.numerator * (wanted / time.denominator)}${sign}${digits}` : null;
}

/// A time as it is written in the place of an old text: with its unit, if that is s or ms, and with
/// its divisor. The old text is returned if it says the same.
export function timeText(time: Fraction, old: string | null): string {
    const quantity = old === null ? null : parseQuantity(old);
    if (!quantity || ![1, 0.001].includes(quantity.scale)) {
        return timeText(time, '0 s');
    }
    if (fractionOf(quantity.value).numerator * time.denominator
        === time.numerator * fractionOf(quantity.value).denominator) {
        return old as string;
    }
    const inUnit = quantity.scale === 1 ? time : fraction(time.numerator * 1000, time.denominator);
    const number = (quantity.divisor === '' ? null : likeFraction(inUnit, quantity.divisor))
        ?? decimal(inUnit) ?? `${inUnit.numerator} / ${inUnit.denominator}`;
    return number + quantity.unit;
}

/// The texts of values as they were when they were first asked for: those before a drag.
export type OldTexts = (path: KeyPath) => string | null;

export function oldTexts(): OldTexts {
    const known = new Map<string, string | null>();
    return (path) => {
        const key = path.join('/');
        if (!known.has(key)) {
            known.set(key, sourceOf(path)?.text ?? null);
        }
        return known.get(key) ?? null;
    };
}

/// The edit that writes a film time.
export function timeChange(path: KeyPath, time: Fraction, old: OldTexts): Change {
    return { path, value: { yaml: timeText(time, old(path)) } };
}
