/// The colours of the page for drawing on a canvas.
import type { Triple } from '../protocol';
import type { EventGroup } from './strip_state';

export interface Colours {
    back: string;
    surface: string;
    raised: string;
    line: string;
    lineStrong: string;
    text: string;
    soft: string;
    faint: string;
    accent: string;
    onAccent: string;
    named(name: string): string;
    /// A colour of the shot, unless it is too near to the background to be seen.
    contrasting(css: string, linear: Triple): string;
    warning: string;
    clips: readonly string[];
    groups: Readonly<Record<EventGroup, string>>;
    font: string;
}

const kClips = 6;

/// Whether a linear colour is hard to see on the page's background.
function isTooNear(linear: Triple): boolean {
    const luminance = 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2];
    return document.documentElement.dataset['theme'] === 'light'
        ? luminance > 0.45 : luminance < 0.03;
}

/// Reads the custom properties of an element.
export function readColours(element: Element): Colours {
    const style = getComputedStyle(element);
    const of = (name: string) => style.getPropertyValue(`--${name}`).trim();
    return {
        back: of('back'), surface: of('surface'), raised: of('raised'), line: of('line'),
        lineStrong: of('line-strong'), text: of('text'), soft: of('text-soft'),
        faint: of('text-faint'), accent: of('accent'), onAccent: of('on-accent'), named: of,
        contrasting: (css, linear) => isTooNear(linear) ? of('text-soft') : css,
        warning: of('warning'),
        clips: Array.from({ length: kClips }, (_, i) => of(`clip-${i + 1}`)),
        groups: {
            actions: of('event'), contacts: of('text-soft'), cushions: of('accent'),
            pockets: of('good'), rest: of('warning'), changes: of('line-strong'),
        },
        font: of('font'),
    };
}

/// The custom property with the colour of the camera with this index.
export function clipColourName(index: number): string {
    return `clip-${index % kClips + 1}`;
}

/// The colour of the camera with this index, on the strip and wherever else cameras are told apart.
export function clipColour(colours: Colours, index: number): string {
    return colours.clips[index % colours.clips.length] ?? colours.accent;
}

/// A linear colour as CSS has it.
export function cssOfLinear(linear: Triple): string {
    const encode = (value: number) => {
        const v = Math.min(Math.max(value, 0), 1);
        return Math.round(255 * (v <= 0.0031308 ? 12.92 * v : 1.055 * v ** (1 / 2.4) - 0.055));
    };
    return `rgb(${encode(linear[0])} ${encode(linear[1])} ${encode(linear[2])})`;
}
