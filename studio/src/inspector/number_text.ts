/// Numbers as they are typed into fields and changed by steps.
import type { Change } from '../edit/edit';
import { parseQuantity } from '../edit/quantity';
import type { NumberType, ValueType } from '../schema/value_types';
import type { KeyPath } from '../protocol';

/// The step of a number as written: one in its last decimal, at least two decimals for small ones.
function stepOf(number: string, isInteger: boolean): number {
    const decimals = /\.(\d+)/.exec(number)?.[1]?.length ?? 0;
    const size = Math.abs(Number(number));
    return isInteger ? 1 : Math.min(10 ** -decimals, size >= 10 ? 1 : size >= 1 ? 0.1 : 0.01);
}

export function numberType(types: readonly ValueType[]): NumberType | undefined {
    return types.find((type): type is NumberType => type.kind === 'number');
}

/// A number that can be changed by steps, with its unit; null if the text is none.
export interface Steppable {
    value: number; // SI
    step: number; // SI
    low: number;
    high: number;
}

export function steppable(text: string, type: NumberType | undefined): Steppable | null {
    const quantity = parseQuantity(text);
    if (!quantity) {
        return null;
    }
    const step = quantity.divisor === '' ? stepOf(quantity.number, type?.isInteger ?? false) : 0.01;
    return { value: quantity.value, step: step * quantity.scale, low: type?.low ?? -Infinity,
        high: type?.high ?? Infinity };
}

/// The change that moves a number by some of its steps.
export function stepped(path: KeyPath, from: Steppable, steps: number, fine: number): Change {
    const step = from.step * fine;
    const value = Math.min(from.high, Math.max(from.low, from.value + steps * step));
    return { path, value: Number(value.toPrecision(12)), precision: Math.min(step, from.step) };
}

/// A typed text as it is written: a plain number gets the unit of the text before it.
export function typed(text: string, before: string, type: NumberType | undefined): string {
    const plain = text.trim();
    if (!/^[-+]?(\d+\.?\d*|\.\d+)(e[-+]?\d+)?$/i.test(plain)) {
        return plain;
    }
    const unit = parseQuantity(before)?.unit ?? '';
    const needsUnit = type?.needsUnit && (Number(plain) !== 0 || type.zeroNeedsUnit);
    return unit !== '' ? `${plain}${unit}` : needsUnit ? `${plain} ${type.unit}` : plain;
}

/// How much of its range a number fills, from 0 to 1; null without a range.
export function shareOf(number: Steppable | null): number | null {
    return number && Number.isFinite(number.low) && Number.isFinite(number.high)
        ? (number.value - number.low) / (number.high - number.low) : null;
}
