import { effect, signal } from '@preact/signals';
import { useEffect, useRef } from 'preact/hooks';
import { filmDuration, framesOfCameras } from '../motion/clock';
import { bindingOf, keyName, runCommand, type Command } from '../state/keys';
import { filmTime, isStale, sceneTime, selection, shot, theme, timeline } from '../state/state';
import { filmClock, sceneClock } from './clock_text';
import { readColours } from './colours';
import { drawPlayHead, drawStrip, type StripPicture } from './draw';
import { layoutOf, type Layout } from './layout';
import { startPlayback } from './playback';
import { followPlayHead, watchPointer, type Tip } from './pointer';
import {
    curveCamera, curveName, fitOnNewShot, shownEvents, shownFilm, shownScene,
} from './strip_state';
import { Transport } from './Transport';
import './strip.css';

const size = signal({ width: 0, height: 0 });
const tip = signal<Tip | null>(null);

function currentLayout(): Layout {
    return layoutOf(size.value.width, size.value.height, shownFilm.value, shownScene.value);
}

function pictureOf(canvas: HTMLCanvasElement): StripPicture {
    const [section, index] = selection.value ?? [];
    return {
        layout: currentLayout(), colours: readColours(canvas), shot: shot.value,
        frames: framesOfCameras.value, events: shownEvents.value,
        energy: timeline.value?.head.energy ?? [], curve: curveName.value,
        curveCamera: curveCamera.value, selected: section === 'cameras' ? Number(index) : -1,
        isStale: isStale.value,
    };
}

/// Gives a canvas the display's own pixels. Returns its pen, scaled to CSS pixels.
function sized(canvas: HTMLCanvasElement): CanvasRenderingContext2D | null {
    const { width, height } = size.value;
    const ratio = devicePixelRatio || 1;
    const [w, h] = [Math.round(width * ratio), Math.round(height * ratio)];
    if (canvas.width !== w || canvas.height !== h) {
        canvas.width = w;
        canvas.height = h;
    }
    // Drawn by the processor: where it draws everything, an accelerated canvas delays all answers.
    const pen = canvas.getContext('2d', { willReadFrequently: true });
    pen?.setTransform(ratio, 0, 0, ratio, 0, 0);
    return pen;
}

/// Draws again whenever something that is drawn has changed; what stands still is drawn apart from
/// the play head. Returns a function that ends this.
function keepDrawn(still: HTMLCanvasElement, moving: HTMLCanvasElement): () => void {
    const endings = [
        effect(() => {
            void theme.value;
            const picture = pictureOf(still);
            const pen = sized(still);
            if (pen && size.value.width > 0) {
                drawStrip(pen, picture);
            }
        }),
        effect(() => {
            void theme.value;
            const layout = currentLayout();
            const pen = sized(moving);
            if (pen && size.value.width > 0) {
                pen.clearRect(0, 0, layout.width, layout.height);
                drawPlayHead(pen, { layout, colours: readColours(moving) },
                    filmTime.value, sceneTime.value);
            }
        }),
    ];
    return () => endings.forEach((end) => end());
}

/// The keys of time, which a slider would otherwise keep for itself.
function onKey(event: KeyboardEvent): void {
    const binding = bindingOf(keyName(event));
    if (binding?.group === 'Time' && runCommand(binding.command as Command)) {
        event.preventDefault();
    }
}

/// The time strip: film time above, scene time below, the map between them, and the transport.
export function TimeStrip() {
    const still = useRef<HTMLCanvasElement>(null);
    const moving = useRef<HTMLCanvasElement>(null);
    useEffect(() => {
        const [below, above] = [still.current, moving.current];
        if (!below || !above) {
            return undefined;
        }
        const observer = new ResizeObserver(() => {
            size.value = { width: above.clientWidth, height: above.clientHeight };
        });
        observer.observe(above);
        const endings = [
            startPlayback(), fitOnNewShot(), keepDrawn(below, above),
            watchPointer(above, currentLayout, (next) => { tip.value = next; }),
            followPlayHead(() => filmTime.value, currentLayout),
            () => observer.disconnect(),
        ];
        return () => endings.forEach((end) => end());
    }, []);
    const text = `film ${filmClock(filmTime.value)}, scene ${sceneClock(sceneTime.value)}`;
    const place = tip.value && {
        left: `${Math.min(tip.value.x + 12, size.value.width - 230)}px`,
        bottom: `${size.value.height - tip.value.y + 12}px`,
    };
    return (
        <section class="strip" aria-label="Time">
            <Transport />
            <div class="times">
                <canvas ref={still} aria-hidden="true" />
                <canvas ref={moving} tabIndex={0} role="slider" aria-label="Play head"
                    aria-valuemin={0} aria-valuemax={filmDuration.value}
                    aria-valuenow={filmTime.value} aria-valuetext={text} onKeyDown={onKey} />
                {tip.value && place
                    ? <div class="tip" role="tooltip" style={place}>{tip.value.text}</div> : null}
            </div>
        </section>
    );
}
