/// What happens in the scene: how fast the balls are, their energy, and all events.
import { xOf } from '../axis';
import { cssOfLinear } from '../colours';
import { binsOf } from '../event_bins';
import type { Pen, StripPicture } from './picture';

function drawEnergy(pen: Pen, { layout, colours, energy }: StripPicture): void {
    const { scene, motion: row } = layout;
    let most = 1e-9;
    for (let i = 1; i < energy.length; i += 3) {
        most = Math.max(most, energy[i] ?? 0);
    }
    const bottom = row.y + row.height;
    pen.save();
    pen.beginPath();
    pen.moveTo(xOf(scene, energy[0] ?? 0), bottom);
    for (let i = 0; i + 1 < energy.length; i += 3) {
        const share = Math.sqrt(Math.max(0, energy[i + 1] ?? 0) / most);
        pen.lineTo(xOf(scene, energy[i] ?? 0), bottom - share * (row.height - 4));
    }
    pen.lineTo(xOf(scene, energy[energy.length - 3] ?? 0), bottom);
    pen.globalAlpha *= 0.2;
    pen.fillStyle = colours.accent;
    pen.fill();
    pen.restore();
}

/// The energy of all, and the speed of each ball by a line in its colour.
export function drawMotion(pen: Pen, picture: StripPicture, start: number, end: number): void {
    const { layout: { scene, motion: row }, balls, fastest, colours } = picture;
    drawEnergy(pen, picture);
    const bottom = row.y + row.height - 1;
    pen.save();
    pen.lineJoin = 'round';
    for (const { speeds, colour } of balls) {
        const step = (end - start) / (speeds.length - 1);
        pen.beginPath();
        let isDown = false;
        speeds.forEach((speed, i) => {
            const before = speeds[i - 1] ?? 0;
            if (speed > 0 || before > 0) {
                const [x, y] = [xOf(scene, start + i * step),
                    bottom - Math.sqrt(speed / fastest) * (row.height - 5)];
                if (isDown) {
                    pen.lineTo(x, y);
                } else {
                    pen.moveTo(xOf(scene, start + Math.max(0, i - 1) * step), bottom);
                    pen.lineTo(x, y);
                }
            }
            isDown = speed > 0;
        });
        pen.strokeStyle = colours.contrasting(cssOfLinear(colour), colour);
        pen.lineWidth = 1;
        pen.globalAlpha = 0.85;
        pen.stroke();
    }
    pen.restore();
}

const kDot = 2.6; // px

export function drawEvents(pen: Pen, { layout, colours, events }: StripPicture): void {
    const { events: row, scene } = layout;
    const levels = Math.max(1, Math.floor((row.height - 10) / 6));
    for (const bin of binsOf(events, scene)) {
        bin.groups.slice(0, levels).forEach((group, i) => {
            pen.fillStyle = colours.groups[group];
            pen.beginPath();
            pen.arc(bin.x, row.y + row.height - 4 - 6 * i, kDot, 0, 2 * Math.PI);
            pen.fill();
        });
    }
}
