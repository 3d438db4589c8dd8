/// The film's sound: the highest magnitude in each column of pixels.
import { timeAt, xOf } from '../axis';
import type { Pen, StripPicture } from './picture';

/// The share of the row's half height that a magnitude fills. The square root, so that rolling and
/// soft contacts are seen beside the loudest blow: 20 dB less are a third of the height.
export function heightOf(peak: number): number {
    return Math.sqrt(peak);
}

export function drawSound(pen: Pen, picture: StripPicture): void {
    const { layout: { film, sound: row }, colours, sound, isSoundStale } = picture;
    if (row.height === 0) {
        return;
    }
    const middle = row.y + row.height / 2;
    const half = row.height / 2 - 2;
    const end = Math.min(film.left + film.width, xOf(film, picture.film?.duration ?? film.to));
    const begin = Math.max(film.left, Math.floor(xOf(film, 0)));
    pen.save();
    pen.globalAlpha *= isSoundStale ? 0.4 : 1;
    pen.fillStyle = colours.lineStrong;
    pen.fillRect(begin, middle - 0.5, Math.max(0, end - begin), 1);
    pen.fillStyle = colours.soft;
    for (let x = begin; sound && x < end; x += 1) {
        const peak = sound.peak(timeAt(film, x), timeAt(film, x + 1));
        if (peak) {
            const height = Math.max(0.5, heightOf(peak) * half);
            pen.fillRect(x, middle - height, 1, 2 * height);
        }
    }
    pen.restore();
}
