/// Draws the strip. What does not depend on the play head is drawn by `drawStrip`, the play head by
/// `drawPlayHead` above it.
import type { CameraFramesOf } from '../motion/camera_frames';
import { sceneTimeAt, speedAt } from '../motion/time_map';
import type { Camera, ShotState, TimelineEvent } from '../protocol';
import { decimalsOf, ticksOf, timeAt, xOf, type Axis } from './axis';
import { speedText } from './clock_text';
import { clipColour, type Colours } from './colours';
import { curveOf, curveText, scaleOf } from './curves';
import { kLabels, type Layout, type Row } from './layout';
import { binsOf } from './event_bins';
import type { CurveName } from './strip_state';

/// All that is drawn.
export interface StripPicture {
    layout: Layout;
    colours: Colours;
    shot: ShotState | null;
    frames: readonly CameraFramesOf[];
    events: readonly TimelineEvent[];
    energy: readonly number[];
    curve: CurveName;
    curveCamera: Camera | null;
    selected: number; // index of the selected camera, or -1
    isStale: boolean;
}

type Pen = CanvasRenderingContext2D;

const kTickSpacing = 88;

function clipTo(pen: Pen, { film }: Layout, row: Row): void {
    pen.beginPath();
    pen.rect(film.left - 6, row.y, film.width + 12, row.height);
    pen.clip();
}

function inRow(pen: Pen, layout: Layout, row: Row, draw: () => void): void {
    pen.save();
    clipTo(pen, layout, row);
    draw();
    pen.restore();
}

function drawRuler(pen: Pen, picture: StripPicture, row: Row, axis: Axis, ticksAtTop: boolean): void {
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

function drawLabels(pen: Pen, { layout, colours, curve }: StripPicture): void {
    pen.font = `11px ${colours.font}`;
    pen.textAlign = 'right';
    pen.textBaseline = 'middle';
    const label = (text: string, row: Row, colour = colours.faint) => {
        pen.fillStyle = colour;
        pen.fillText(text, kLabels - 14, row.y + row.height / 2);
    };
    const names = { speed: 'Speed', fov: 'View', focus: 'Focus', aperture: 'Aperture' };
    label('Film', layout.filmRuler, colours.soft);
    label('Cameras', layout.clips);
    label(names[curve], layout.curve);
    label('Energy', layout.energy);
    label('Events', layout.events);
    label('Scene', layout.sceneRuler, colours.soft);
}

/// The short text behind a camera's name: its speed, or that it stands still or has a ramp.
function speedLabel(camera: Camera): string {
    const speed = speedAt(camera, camera.video_start);
    return camera.speeds.length > 1 ? 'ramp' : Math.abs(speed) < 1e-9 ? 'still' : speedText(speed);
}

function drawClips(pen: Pen, picture: StripPicture): void {
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

function drawCurves(pen: Pen, picture: StripPicture): void {
    const { layout, colours, shot, frames, curve, curveCamera } = picture;
    const row = layout.curve;
    const all = (shot?.cameras ?? []).map((camera, i) => curveOf(curve, camera, frames[i]));
    const scale = scaleOf(curve, all.flat());
    const yOf = (value: number) => row.y + row.height - 4
        - (value - scale.low) / (scale.high - scale.low) * (row.height - 8);
    if (curve === 'speed') {
        pen.strokeStyle = colours.line;
        for (const level of [0, 1]) {
            const y = Math.round(yOf(level)) + 0.5;
            pen.beginPath();
            pen.moveTo(layout.film.left, y);
            pen.lineTo(layout.film.left + layout.film.width, y);
            pen.stroke();
        }
    }
    all.forEach((points, index) => {
        const isShown = shot?.cameras[index] === curveCamera;
        pen.save();
        pen.globalAlpha *= isShown ? 1 : 0.4;
        pen.strokeStyle = clipColour(colours, index);
        pen.lineWidth = isShown ? 1.75 : 1.25;
        pen.beginPath();
        points.forEach(({ time, value }, i) => {
            const [x, y] = [xOf(layout.film, time), yOf(value)];
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
            pen.fillText(curveText(curve, last.value), xOf(layout.film, last.time) - 4,
                Math.max(row.y + 8, Math.min(row.y + row.height - 8, yOf(last.value) - 8)));
        }
        pen.restore();
    });
}

const kMapSpacing = 9; // px between lines of the map

function drawMap(pen: Pen, { layout, colours, shot, selected }: StripPicture): void {
    const { film, scene, map } = layout;
    shot?.cameras.forEach((camera, index) => {
        const length = camera.video_end - camera.video_start;
        const pixels = length / (film.to - film.from) * film.width;
        const count = Math.max(1, Math.min(400, Math.floor(pixels / kMapSpacing)));
        pen.strokeStyle = clipColour(colours, index);
        for (let i = 0; i <= count; i += 1) {
            const time = camera.video_start + length * (i / count);
            const isEnd = i === 0 || i === count;
            pen.globalAlpha = isEnd ? 0.95 : index === selected ? 0.45 : 0.24;
            pen.lineWidth = isEnd ? 1.5 : 1;
            pen.beginPath();
            pen.moveTo(xOf(film, time), map.y);
            pen.lineTo(xOf(scene, sceneTimeAt(camera, time)), map.y + map.height);
            pen.stroke();
        }
    });
    pen.globalAlpha = 1;
    pen.lineWidth = 1;
}

function drawEnergy(pen: Pen, { layout, colours, energy }: StripPicture): void {
    const { scene, energy: row } = layout;
    let most = 1e-9;
    for (let i = 1; i < energy.length; i += 3) {
        most = Math.max(most, energy[i] ?? 0);
    }
    const bottom = row.y + row.height;
    pen.beginPath();
    pen.moveTo(xOf(scene, energy[0] ?? 0), bottom);
    for (let i = 0; i + 1 < energy.length; i += 3) {
        const share = Math.sqrt(Math.max(0, energy[i + 1] ?? 0) / most);
        pen.lineTo(xOf(scene, energy[i] ?? 0), bottom - share * (row.height - 4));
    }
    pen.lineTo(xOf(scene, energy[energy.length - 3] ?? 0), bottom);
    pen.globalAlpha = 0.22;
    pen.fillStyle = colours.accent;
    pen.fill();
    pen.globalAlpha = 1;
}

function drawEvents(pen: Pen, { layout, colours, events, shot }: StripPicture): void {
    const { events: row, scene } = layout;
    const levels = Math.max(1, Math.floor((row.height - 4) / 6));
    for (const bin of binsOf(events, scene)) {
        bin.groups.slice(0, levels).forEach((group, i) => {
            pen.fillStyle = colours.groups[group];
            pen.beginPath();
            pen.arc(bin.x, row.y + row.height - 5 - 6 * i, 2.5, 0, 2 * Math.PI);
            pen.fill();
        });
    }
    for (const event of shot?.events ?? []) {
        const x = xOf(scene, event.time);
        pen.fillStyle = colours.groups.actions;
        pen.beginPath();
        pen.moveTo(x - 5, row.y);
        pen.lineTo(x + 5, row.y);
        pen.lineTo(x, row.y + 8);
        pen.fill();
    }
}

/// Everything but the play head.
export function drawStrip(pen: Pen, picture: StripPicture): void {
    const { layout, colours } = picture;
    pen.clearRect(0, 0, layout.width, layout.height);
    pen.fillStyle = colours.surface;
    pen.fillRect(0, 0, layout.width, layout.height);
    pen.fillStyle = colours.back;
    pen.fillRect(layout.film.left - 6, layout.clips.y, layout.film.width + 12,
        layout.sceneRuler.y - layout.clips.y);
    drawLabels(pen, picture);
    inRow(pen, layout, layout.filmRuler, () =>
        drawRuler(pen, picture, layout.filmRuler, layout.film, false));
    inRow(pen, layout, layout.sceneRuler, () =>
        drawRuler(pen, picture, layout.sceneRuler, layout.scene, true));
    pen.globalAlpha = picture.isStale ? 0.5 : 1;
    inRow(pen, layout, layout.clips, () => drawClips(pen, picture));
    inRow(pen, layout, layout.curve, () => drawCurves(pen, picture));
    inRow(pen, layout, layout.map, () => drawMap(pen, picture));
    inRow(pen, layout, layout.energy, () => drawEnergy(pen, picture));
    inRow(pen, layout, layout.events, () => drawEvents(pen, picture));
    pen.globalAlpha = 1;
}

/// Both play heads and the line of the map between them.
export function drawPlayHead(
    pen: Pen, { layout, colours }: Pick<StripPicture, 'layout' | 'colours'>,
    filmTime: number, sceneTime: number,
): void {
    const { film, scene, map } = layout;
    const above = xOf(film, filmTime);
    const below = xOf(scene, sceneTime);
    pen.save();
    pen.beginPath();
    pen.rect(film.left - 6, 0, film.width + 12, layout.height);
    pen.clip();
    pen.strokeStyle = colours.accent;
    pen.fillStyle = colours.accent;
    pen.lineWidth = 1.5;
    pen.beginPath();
    pen.moveTo(above, 4);
    pen.lineTo(above, map.y);
    pen.lineTo(below, map.y + map.height);
    pen.lineTo(below, layout.height - 4);
    pen.stroke();
    for (const [x, y, side] of [[above, 2, 1], [below, layout.height - 2, -1]] as const) {
        pen.beginPath();
        pen.moveTo(x - 5, y);
        pen.lineTo(x + 5, y);
        pen.lineTo(x + 5, y + 5 * side);
        pen.lineTo(x, y + 10 * side);
        pen.lineTo(x - 5, y + 5 * side);
        pen.fill();
    }
    pen.restore();
}

/// The time under the pointer, of the film or of the scene.
export function timeUnder(layout: Layout, x: number, isFilm: boolean): number {
    return timeAt(isFilm ? layout.film : layout.scene, x);
}
