/// The two rulers, and the names of the rows.
import { decimalsOf, ticksOf, xOf, type Axis } from '../axis';
import { kLabels, laneOf, type Row } from '../layout';
import type { Pen, StripPicture } from './picture';

const kTickSpacing = 88;

export function drawRuler(pen: Pen, picture: StripPicture, row: Row, axis: Axis, ticksAtTop: boolean): void {
    const { colours } = picture;
    const decimals = decimalsOf(axis, kTickSpacing);
    pen.font = `10.5px ${colours.font}`;
    pen.textAlign = 'left';
    pen.textBaseline = 'middle';
    for (const { time, major } of ticksOf(axis, kTickSpacing)) {
        const x = Math.round(xOf(axis, time)) + 0.5;
        const length = major ? 7 : 4;
        const border = ticksAtTop ? row.y + 0.5 : row.y + row.height - 0.5;
        pen.strokeStyle = major ? colours.lineStrong : colours.line;
        pen.beginPath();
        pen.moveTo(x, border);
        pen.lineTo(x, border + (ticksAtTop ? length : -length));
        pen.stroke();
        if (major && time > -1e-9) {
            pen.fillStyle = colours.faint;
            pen.fillText(`${Math.abs(time).toFixed(decimals)} s`, x + 4, row.y + row.height / 2);
        }
    }
}

export function drawLabels(pen: Pen, { layout, colours, curve, isSequence }: StripPicture): void {
    pen.font = `11px ${colours.font}`;
    pen.textAlign = 'right';
    pen.textBaseline = 'middle';
    const label = (text: string, row: Row, colour = colours.faint) => {
        pen.fillStyle = colour;
        pen.fillText(text, kLabels - 14, row.y + row.height / 2);
    };
    const names = { speed: 'Speed', fov: 'View', focus: 'Focus', aperture: 'Aperture' };
    label('Film', layout.filmRuler, colours.soft);
    if (layout.frames.height > 0) {
        label('Frames', layout.frames);
    }
    if (layout.sound.height > 0) {
        label('Sound', layout.sound);
    }
    if (isSequence) {
        label('Parts', laneOf(layout.clips, 0));
        return;
    }
    label('Cameras', layout.clips);
    label(names[curve], layout.curve);
    label('Balls', layout.motion);
    label('Map', layout.map);
    label('Events', layout.events);
    label('Scene', layout.sceneRuler, colours.soft);
}
