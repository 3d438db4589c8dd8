/// Numbers as carom's YAML has them, with units and fractions, and how to write another value in
/// the same way.
import { unitValue } from './units';

export interface Quantity {
    /// In SI units.
    value: number;
    /// Of the unit, in SI units.
    scale: number;
    /// "-0.75", "1e-3"; of a fraction its numerator.
    number: string;
    /// " / 48" as written, or empty.
    divisor: string;
    /// The unit with the space before it, as written: " deg", or empty.
    unit: string;
}

const kQuantity = /^([-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)(\s*\/\s*[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)?(\s*)(.*)$/;
const kDigits = 12;  // significant digits of values whose precision nobody named

/// Reads a number with or without a unit; null if the text is none.
export function parseQuantity(text: string): Quantity | null {
    const parts = kQuantity.exec(text.trim());
    if (!parts) {
        return null;
    }
    const [, number = '', divisor = '', space = '', unit = ''] = parts;
    const scale = unitValue(unit);
    if (scale === null) {
        return null;
    }
    const divided = divisor === '' ? 1 : Number(divisor.replace('/', '').trim());
    const value = (Number(number) / divided) * scale;
    return Number.isFinite(value) ? { value, scale, number, divisor, unit: space + unit } : null;
}

/// The number of decimals that a step needs: 0.1 one, 0.5 one, 1/24 four.
function decimalsOf(step: number): number {
    const decimals = Math.max(0, Math.ceil(-Math.log10(step) - 1e-9));
    const units = step * 10 ** decimals;
    return Math.abs(units - Math.round(units)) < 1e-6 ? decimals : decimals + 2;
}

/// A number as short as it can be, rounded to `step` if one is given.
export function writeNumber(value: number, step?: number): string {
    if (step === undefined || !(step > 0)) {
        return String(Number(value.toPrecision(kDigits)) + 0);
    }
    const text = (Math.round(value / step) * step).toFixed(Math.min(15, decimalsOf(step)));
    const short = text.includes('.') ? text.replace(/\.?0+$/, '') : text;
    return short === '-0' ? '0' : short;
}

/// `text` with zeros up to as many decimals as `old` has, if `old` ends with a zero: 0.40 -> 0.50.
function padLike(old: string, text: string): string {
    const decimals = /\.(\d*0)$/.exec(old)?.[1]?.length ?? 0;
    if (decimals === 0 || !/^-?\d+(\.\d+)?$/.test(text)) {
        return text;
    }
    const own = /\.(\d+)$/.exec(text)?.[1]?.length ?? 0;
    return own >= decimals ? text : Number(text).toFixed(decimals);
}

/// `value` as a fraction like the old one, or null if it is no such fraction.
function writeFraction(old: Quantity, value: number): string | null {
    const numerator = Number(old.number);
    const denominator = Number(old.divisor.replace('/', '').trim());
    const isWhole = (x: number) => Math.abs(x - Math.round(x)) < 1e-9 * Math.max(1, Math.abs(x));
    if (isWhole(value * denominator)) {
        return old.divisor.replace(/[-+\d.eE]+$/, '').replace(/^/, String(Math.round(value * denominator)))
            + String(denominator);
    }
    if (value !== 0 && isWhole(numerator / value) && Math.abs(numerator / value) < 1e6) {
        return old.number + old.divisor.replace(/[-+\d.eE]+$/, '')
            + String(Math.round(numerator / value));
    }
    return null;
}

function writeExponent(old: string, value: number): string {
    const text = Number(value.toPrecision(kDigits)).toExponential();
    return old.includes('E') ? text.replace('e', 'E') : text;
}

/// Whether both values are the same at a precision.
function isSame(a: number, b: number, precision: number | undefined): boolean {
    const difference = Math.abs(a - b);
    return precision !== undefined && precision > 0
        ? difference < precision / 2
        : difference <= 1e-13 * Math.max(Math.abs(a), Math.abs(b));
}

/// `value` (SI) written as `old` is: with its unit, as a fraction, with an exponent. Not finer than
/// `precision` (SI). The old text is returned if it has this value already.
export function writeLike(old: Quantity, value: number, precision?: number): string {
    if (isSame(old.value, value, precision)) {
        return old.number + old.divisor + old.unit;
    }
    const inUnit = value / old.scale;
    if (old.divisor !== '') {
        const fraction = writeFraction(old, inUnit);
        if (fraction !== null) {
            return fraction + old.unit;
        }
    }
    const step = precision === undefined ? undefined : precision / old.scale;
    if (/e/i.test(old.number) && step === undefined && inUnit !== 0) {
        return writeExponent(old.number, inUnit) + old.unit;
    }
    const number = padLike(old.number, writeNumber(inUnit, step));
    const sign = old.number.startsWith('+') && !number.startsWith('-') ? '+' : '';
    return sign + number + old.unit;
}
