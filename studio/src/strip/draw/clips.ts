/// The cameras' clips and the film's frames.
import { speedAt } from '../../motion/time_map';
import type { Camera } from '../../protocol';
import { xOf } from '../axis';
import { speedText } from '../clock_text';
import { clipColour } from '../colours';
import type { Pen, StripPicture } from './picture';

/// The short text behind a camera's name: its speed, or that it stands still or has a ramp.
function speedLabel(camera: Camera): string {
    const speed = speedAt(camera, camera.video_start);
    return camera.speeds.length > 1 ? 'ramp' : Math.abs(speed) < 1e-9 ? 'still' : speedText(speed);
}

export function drawClips(pen: Pen, picture: StripPicture): void {
    const { layout, colours, shot, selected } = picture;
    const { film } = layout;
    const row = layout.clips;
    shot?.cameras.forEach((camera, index) => {
        const left = xOf(film, camera.video_start);
        const right = xOf(film, camera.video_end);
        const colour = clipColour(colours, index);
        const width = Math.max(2, right - left - 1);
        pen.beginPath();
        pen.roundRect(left + 0.5, row.y + 2.5, width, row.height - 5, 4);
        pen.fillStyle = colours.raised;
        pen.fill();
        pen.save();
        pen.globalAlpha *= index === selected ? 0.55 : 0.26;
        pen.fillStyle = colour;
        pen.fill();
        pen.restore();
        pen.strokeStyle = index === selected ? colours.accent : colour;
        pen.lineWidth = index === selected ? 1.5 : 1;
        pen.stroke();
        pen.lineWidth = 1;
        if (camera.fade > 0) {
            const end = xOf(film, camera.video_start + camera.fade);
            pen.beginPath();
            pen.moveTo(left, row.y + row.height - 3);
            pen.lineTo(end, row.y + 3);
            pen.stroke();
        }
        pen.save();
        pen.beginPath();
        pen.rect(Math.max(left, film.left) + 4, row.y, width - 8, row.height);
        pen.clip();
        const x = Math.max(left, film.left) + 9;
        const middle = row.y + row.height / 2 + 0.5;
        pen.textAlign = 'left';
        pen.textBaseline = 'middle';
        pen.font = `600 11.5px ${colours.font}`;
        pen.fillStyle = colours.text;
        pen.fillText(camera.name, x, middle);
        const after = x + pen.measureText(camera.name).width + 8;
        pen.font = `11px ${colours.font}`;
        pen.fillStyle = colours.soft;
        const arrow = speedAt(camera, camera.video_start) < 0 ? '◂ ' : '';
        pen.fillText(arrow + speedLabel(camera), after, middle);
        pen.restore();
    });
}
