/// Draws the strip. What does not depend on the play head is drawn by `drawStrip`, the play head by
/// `drawPlayHead` above it.
import type { FilmInstant } from '../../motion/time_map';
import { xOf } from '../axis';
import { clipColour } from '../colours';
import type { Layout, Row } from '../layout';
import { drawClips } from './clips';
import { drawCurves, drawMap } from './curves';
import { drawFrames } from './frames';
import { drawHandles } from './handles';
import { drawEvents, drawMotion } from './motion';
import { drawParts } from './parts';
import type { Pen, StripPicture } from './picture';
import { drawSound } from './sound';
import { drawLabels, drawRuler } from './rulers';

function inRow(pen: Pen, { film }: Layout, row: Row, draw: () => void): void {
    pen.save();
    pen.beginPath();
    pen.rect(film.left - 6, row.y, film.width + 12, row.height);
    pen.clip();
    draw();
    pen.restore();
}

/// Everything but the play head. `onPicture` is called when a small picture of a frame comes later.
export function drawStrip(
    pen: Pen, picture: StripPicture, start: number, end: number, onPicture: () => void,
): void {
    const { layout, colours } = picture;
    const { film, filmRuler, sceneRuler } = layout;
    pen.clearRect(0, 0, layout.width, layout.height);
    pen.fillStyle = colours.surface;
    pen.fillRect(0, 0, layout.width, layout.height);
    pen.fillStyle = colours.back;
    const top = filmRuler.y + filmRuler.height;
    pen.fillRect(film.left - 6, top, film.width + 12, sceneRuler.y - top);
    drawLabels(pen, picture);
    inRow(pen, layout, filmRuler, () => drawRuler(pen, picture, filmRuler, film, false));
    inRow(pen, layout, sceneRuler, () => drawRuler(pen, picture, sceneRuler, layout.scene, true));
    pen.globalAlpha = picture.isStale ? 0.5 : 1;
    inRow(pen, layout, layout.frames, () => drawFrames(pen, picture, onPicture));
    inRow(pen, layout, layout.sound, () => drawSound(pen, picture));
    if (picture.isSequence) {
        inRow(pen, layout, layout.clips, () => drawParts(pen, picture));
        pen.globalAlpha = 1;
        drawHandles(pen, picture);
        return;
    }
    inRow(pen, layout, layout.clips, () => drawClips(pen, picture));
    inRow(pen, layout, layout.curve, () => drawCurves(pen, picture));
    inRow(pen, layout, layout.map, () => drawMap(pen, picture));
    inRow(pen, layout, layout.motion, () => drawMotion(pen, picture, start, end));
    inRow(pen, layout, layout.events, () => drawEvents(pen, picture));
    pen.globalAlpha = 1;
    drawHandles(pen, picture);
}

function drawHead(pen: Pen, x: number, y: number, side: 1 | -1): void {
    pen.beginPath();
    pen.moveTo(x - 5, y);
    pen.lineTo(x + 5, y);
    pen.lineTo(x + 5, y + 5 * side);
    pen.lineTo(x, y + 10 * side);
    pen.lineTo(x - 5, y + 5 * side);
    pen.closePath();
}

/// Both play heads, the line of the map between them, and the other instants of the film that show
/// the same time of the scene.
export function drawPlayHead(
    pen: Pen, { layout, colours }: Pick<StripPicture, 'layout' | 'colours'>,
    filmTime: number, sceneTime: number, others: readonly FilmInstant[],
): void {
    const { film, scene, map } = layout;
    const above = xOf(film, filmTime);
    const below = xOf(scene, sceneTime);
    pen.save();
    pen.beginPath();
    pen.rect(film.left - 6, 0, film.width + 12, layout.height);
    pen.clip();
    for (const { time, camera } of others) {
        const x = xOf(film, time);
        pen.strokeStyle = clipColour(colours, camera);
        pen.fillStyle = colours.surface;
        pen.lineWidth = 1.5;
        pen.setLineDash([3, 3]);
        pen.beginPath();
        pen.moveTo(x, 12);
        pen.lineTo(x, map.y);
        pen.lineTo(below, map.y + map.height);
        pen.stroke();
        pen.setLineDash([]);
        drawHead(pen, x, 2, 1);
        pen.fill();
        pen.stroke();
    }
    pen.strokeStyle = colours.accent;
    pen.fillStyle = colours.accent;
    pen.lineWidth = 1.5;
    pen.beginPath();
    pen.moveTo(above, 4);
    pen.lineTo(above, map.y);
    pen.lineTo(below, map.y + map.height);
    pen.lineTo(below, layout.height - 4);
    pen.stroke();
    drawHead(pen, above, 2, 1);
    pen.fill();
    drawHead(pen, below, layout.height - 2, -1);
    pen.fill();
    pen.restore();
}
