/// The curves of the cameras, and the lines between both clocks.
import { sceneTimeAt } from '../../motion/time_map';
import { xOf } from '../axis';
import { clipColour } from '../colours';
import { curveRow } from '../curve_row';
import { curveText } from '../curves';
import { linesOf } from '../map_lines';
import type { Pen, StripPicture } from './picture';

/// The speed's levels that mean something: standing still and real time.
function drawLevels(pen: Pen, { layout, colours, curveScale }: StripPicture): void {
    const row = curveRow(layout.curve, curveScale);
    pen.strokeStyle = colours.line;
    for (const level of [0, 1]) {
        const y = Math.round(row.yOf(level)) + 0.5;
        pen.beginPath();
        pen.moveTo(layout.film.left, y);
        pen.lineTo(layout.film.left + layout.film.width, y);
        pen.stroke();
    }
}

export function drawCurves(pen: Pen, picture: StripPicture): void {
    const { layout, colours, curves, curve, curveCamera, curveScale } = picture;
    const row = curveRow(layout.curve, curveScale);
    if (curve === 'speed') {
        drawLevels(pen, picture);
    }
    curves.forEach((points, index) => {
        const isShown = index === curveCamera;
        pen.save();
        pen.globalAlpha *= isShown ? 1 : 0.4;
        pen.strokeStyle = clipColour(colours, index);
        pen.lineWidth = isShown ? 1.75 : 1.25;
        pen.beginPath();
        points.forEach(({ time, value }, i) => {
            const [x, y] = [xOf(layout.film, time), row.yOf(value)];
            if (i === 0) {
                pen.moveTo(x, y);
            } else {
                pen.lineTo(x, y);
            }
        });
        pen.stroke();
        const last = points.at(-1);
        if (isShown && last) {
            pen.fillStyle = colours.soft;
            pen.font = `10.5px ${colours.font}`;
            pen.textAlign = 'right';
            pen.textBaseline = 'middle';
            const { y, height } = layout.curve;
            pen.fillText(curveText(curve, last.value), xOf(layout.film, last.time) - 8,
                Math.max(y + 8, Math.min(y + height - 8, row.yOf(last.value) - 9)));
        }
        pen.restore();
    });
}

export function drawMap(pen: Pen, { layout, colours, shot, selected }: StripPicture): void {
    const { film, scene, map } = layout;
    pen.save();
    const alpha = pen.globalAlpha;
    shot?.cameras.forEach((camera, index) => {
        pen.strokeStyle = clipColour(colours, index);
        const lines = linesOf(camera, film);
        lines.forEach((time, i) => {
            const isEnd = i === 0 || i === lines.length - 1;
            pen.globalAlpha = alpha * (isEnd ? 0.95 : index === selected ? 0.5 : 0.24);
            pen.lineWidth = isEnd ? 1.5 : 1;
            pen.beginPath();
            pen.moveTo(xOf(film, time), map.y);
            pen.lineTo(xOf(scene, sceneTimeAt(camera, time)), map.y + map.height);
            pen.stroke();
        });
    });
    pen.restore();
}
