import { effect, signal } from '@preact/signals';
import { useEffect, useRef } from 'preact/hooks';
import { filmDuration, framesOfCameras } from '../motion/clock';
import { shownTheme } from '../shell/theme';
import { loadSound } from '../sound/loading';
import { exposeSound, playSound } from '../sound/player';
import { isSoundStale, soundData, soundPieces, toggleMute } from '../sound/sound_state';
import { filmThumbnails } from '../state/film_thumbnails';
import { bindingOf, keyName, onCommand, runCommand, type Command } from '../state/keys';
import { shownPart } from '../sequence/parts';
import {
    filmTime, isSequence, isStale, openFilm, sceneTime, selection, sequence, shot, timeline,
} from '../state/state';
import { ballSpeeds } from './ball_speeds';
import { filmClock, sceneClock } from './clock_text';
import { readColours } from './colours';
import { curvePoints, curveScale } from './curve_row';
import { drawPlayHead, drawStrip } from './draw/draw';
import type { StripPicture } from './draw/picture';
import { activeHandle, selectedCamera, shownHandles } from './handles/all_handles';
import { HandleList } from './HandleList';
import { otherInstants } from './instants';
import { currentLayout, stripSize } from './layout_now';
import { startPlayback } from './playback';
import { watchPointer } from './pointer';
import { exposeStrip } from './exposed';
import { followPlayHead } from './ranges';
import { curveCamera, curveName, fitOnNewShot, shownEvents } from './strip_state';
import type { Tip } from './tips';
import { Transport } from './Transport';
import './strip.css';

const tip = signal<Tip | null>(null);
const picturesCame = signal(0); // how many small pictures of frames came

function pictureOf(canvas: HTMLCanvasElement): StripPicture {
    const camera = curveCamera.value;
    return {
        layout: currentLayout.value, colours: readColours(canvas), shot: shot.value,
        film: openFilm.value, isSequence: isSequence.value, sequence: sequence.value,
        shownPart: shownPart.value,
        frames: framesOfCameras.value, events: shownEvents.value,
        energy: timeline.value?.head.energy ?? [], balls: ballSpeeds.value.balls,
        fastest: ballSpeeds.value.most, curve: curveName.value, curves: curvePoints.value,
        curveScale: curveScale.value, curveCamera: camera ? shot.value?.cameras.indexOf(camera) ?? -1 : -1,
        selected: selectedCamera.value, selectedPath: selection.value?.join('/') ?? '',
        handles: shownHandles.value, activeHandle: activeHandle.value,
        thumbnails: filmThumbnails.value, sound: soundData.value, isSoundStale: isSoundStale.value,
        isStale: isStale.value,
    };
}

/// Gives a canvas the display's own pixels. Returns its pen, scaled to CSS pixels.
function sized(canvas: HTMLCanvasElement): CanvasRenderingContext2D | null {
    const { width, height } = stripSize.value;
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
            void shownTheme.value;
            void [picturesCame.value, soundPieces.value];
            const picture = pictureOf(still);
            const head = timeline.value?.head;
            const pen = sized(still);
            if (pen && stripSize.value.width > 0) {
                drawStrip(pen, picture, head?.start ?? 0, head?.end ?? 1,
                    () => { picturesCame.value += 1; });
            }
        }),
        effect(() => {
            void shownTheme.value;
            const layout = currentLayout.value;
            const pen = sized(moving);
            if (pen && stripSize.value.width > 0) {
                pen.clearRect(0, 0, layout.width, layout.height);
                drawPlayHead(pen, { layout, colours: readColours(moving) },
                    filmTime.value, isSequence.value ? filmTime.value : sceneTime.value,
                    otherInstants.value);
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

/// The play head as screen readers and the keyboard have it.
function PlayHead({ canvas }: { canvas: { current: HTMLCanvasElement | null } }) {
    const text = `film ${filmClock(filmTime.value)}, scene ${sceneClock(sceneTime.value)}`;
    return (
        <canvas ref={canvas} tabIndex={0} role="slider" aria-label="Play head" data-play-head
            aria-valuemin={0} aria-valuemax={filmDuration.value}
            aria-valuenow={filmTime.value} aria-valuetext={text} onKeyDown={onKey} />
    );
}

function StripTip() {
    const size = stripSize.value;
    const place = tip.value && {
        left: `${Math.max(4, Math.min(tip.value.x + 12, size.width - 250))}px`,
        bottom: `${Math.min(size.height - tip.value.y + 14, size.height - 40)}px`,
    };
    return tip.value && place
        ? <div class="tip" role="tooltip" style={place}>{tip.value.text}</div> : null;
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
            stripSize.value = { width: above.clientWidth, height: above.clientHeight };
        });
        observer.observe(above);
        const endings = [
            startPlayback(), loadSound(), playSound(), fitOnNewShot(),
            onCommand('mute', toggleMute), keepDrawn(below, above),
            watchPointer(above, (next) => { tip.value = next; }),
            followPlayHead(), () => observer.disconnect(),
        ];
        exposeStrip(above);
        exposeSound();
        return () => endings.forEach((end) => end());
    }, []);
    return (
        <section class="strip" aria-label="Time">
            <Transport />
            <div class="times">
                <canvas ref={still} aria-hidden="true" />
                <PlayHead canvas={moving} />
                <HandleList />
                <StripTip />
            </div>
        </section>
    );
}
