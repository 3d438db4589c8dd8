/// The film's frames that are made, as small pictures or as a bar.
import { withKey } from '../../connection/key';
import { timeAt, xOf } from '../axis';
import type { Pen, StripPicture } from './picture';

const pictures = new Map<string, HTMLImageElement>();
const kMostPictures = 400;

/// A picture that has come; null while it is under way. `onCome` is called when it comes.
function pictureOf(address: string, onCome: () => void): HTMLImageElement | null {
    const known = pictures.get(address);
    if (known) {
        return known.complete && known.naturalWidth > 0 ? known : null;
    }
    if (pictures.size > kMostPictures) {
        pictures.clear();
    }
    const image = new Image();
    image.onload = onCome;
    image.src = withKey(address);
    pictures.set(address, image);
    return null;
}

/// The nearest frame with a picture, at most `most` frames away; undefined if there is none.
function nearest(made: ReadonlyMap<number, string>, frame: number, most: number): string | undefined {
    for (let away = 0; away <= most; away += 1) {
        const found = made.get(frame + away) || made.get(frame - away);
        if (found) {
            return found;
        }
    }
    return undefined;
}

export function drawFrames(pen: Pen, picture: StripPicture, onCome: () => void): void {
    const { layout: { film, frames: row }, colours, thumbnails } = picture;
    if (row.height === 0 || !picture.film) {
        return;
    }
    const { fps, width, height, frames } = picture.film;
    const inner = row.height - 7;
    const tile = inner * width / height;
    const first = Math.floor((xOf(film, 0) - film.left) / tile);
    for (let i = Math.max(0, -first - 1); xOf(film, 0) + i * tile < film.left + film.width; i += 1) {
        const x = xOf(film, 0) + i * tile;
        const frame = Math.round(timeAt(film, x + tile / 2) * fps);
        const reach = Math.floor(tile / film.width * (film.to - film.from) * fps / 2);
        const address = frame < frames ? nearest(thumbnails, frame, reach) : undefined;
        const image = address ? pictureOf(address, onCome) : null;
        if (image) {
            pen.drawImage(image, x, row.y + 1, tile - 1, inner);
        }
    }
    pen.fillStyle = colours.accent;
    for (const frame of thumbnails.keys()) {
        const x = xOf(film, frame / fps);
        pen.fillRect(x, row.y + row.height - 4, Math.max(1, xOf(film, (frame + 1) / fps) - x), 2);
    }
}
