/// The parts of a film of several shots, with their fades.
import type { FilmPart } from '../../protocol';
import { xOf } from '../axis';
import { clipColour } from '../colours';
import { laneOf, type Row } from '../layout';
import type { Pen, StripPicture } from './picture';

const kCorner = 4; // px
const kLeastText = 14; // px of width, below which a part has no text

/// "frames 12 to 107 of 192" of the shot, or how long a title card is shown.
export function partAbout({ kind, frames, first, of_frames }: FilmPart, fps: number): string {
    const seconds = `${(frames / fps).toFixed(2)} s`;
    const isWhole = first === 0 && frames === of_frames;
    return kind === 'title' ? seconds
        : isWhole ? `${seconds}, the whole shot`
            : `${seconds}, from ${(first / fps).toFixed(2)} to ${((first + frames) / fps).toFixed(2)} s`;
}

function drawText(pen: Pen, picture: StripPicture, part: FilmPart, [left, right]: [number, number], lane: Row): void {
    const { layout: { film }, colours } = picture;
    const from = Math.max(left, film.left) + 9;
    if (right - from < kLeastText) {
        return;
    }
    const isTall = lane.height >= 32;
    const middle = lane.y + lane.height / 2 + 0.5;
    pen.save();
    pen.beginPath();
    pen.rect(from - 5, lane.y, right - from, lane.height);
    pen.clip();
    pen.textAlign = 'left';
    pen.textBaseline = 'middle';
    pen.font = `${part.kind === 'title' ? 'italic ' : ''}600 11.5px ${colours.font}`;
    pen.fillStyle = colours.text;
    const name = part.name.replace(/\s+/g, ' ');
    pen.fillText(name, from, isTall ? middle - 8 : middle);
    const after = isTall ? from : from + pen.measureText(name).width + 8;
    pen.font = `11px ${colours.font}`;
    pen.fillStyle = colours.soft;
    pen.fillText(partAbout(part, picture.film?.fps ?? 24), after, isTall ? middle + 8 : middle);
    pen.restore();
}

/// The fade of a part as a triangle that grows while the part appears.
function drawFade(pen: Pen, left: number, end: number, lane: Row, colour: string): void {
    pen.save();
    pen.globalAlpha *= 0.5;
    pen.fillStyle = colour;
    pen.beginPath();
    pen.moveTo(left + 0.5, lane.y + lane.height);
    pen.lineTo(end, lane.y);
    pen.lineTo(end, lane.y + lane.height);
    pen.fill();
    pen.restore();
    pen.strokeStyle = colour;
    pen.beginPath();
    pen.moveTo(left + 0.5, lane.y + lane.height);
    pen.lineTo(end, lane.y);
    pen.stroke();
}

function drawPart(pen: Pen, picture: StripPicture, part: FilmPart, index: number): void {
    const { layout, colours, shownPart, selectedPath } = picture;
    const fps = picture.film?.fps ?? 24;
    const lane = laneOf(layout.clips, index);
    const left = xOf(layout.film, part.start / fps);
    const right = xOf(layout.film, (part.start + part.frames) / fps);
    const colour = part.kind === 'title' ? colours.soft : clipColour(colours, index);
    const isSelected = part.path.join('/') === selectedPath;
    pen.beginPath();
    pen.roundRect(left + 0.5, lane.y + 0.5, Math.max(2, right - left - 1), lane.height - 1, kCorner);
    pen.fillStyle = colours.raised;
    pen.fill();
    pen.save();
    pen.globalAlpha *= isSelected ? 0.34 : index === shownPart ? 0.28 : 0.16;
    pen.fillStyle = colour;
    pen.fill();
    pen.clip();
    if (part.fade > 0) {
        drawFade(pen, left, xOf(layout.film, (part.start + part.fade) / fps), lane, colour);
    }
    pen.restore();
    pen.beginPath();
    pen.roundRect(left + 0.5, lane.y + 0.5, Math.max(2, right - left - 1), lane.height - 1, kCorner);
    pen.strokeStyle = isSelected ? colours.accent : colour;
    pen.lineWidth = isSelected || index === shownPart ? 1.75 : 1;
    pen.stroke();
    pen.lineWidth = 1;
    drawText(pen, picture, part, [left, right], lane);
}

/// The parts in two lanes; the one at the play head is stronger.
export function drawParts(pen: Pen, picture: StripPicture): void {
    picture.sequence?.parts.forEach((part, index) => drawPart(pen, picture, part, index));
}
