/// What a part of a film of several shots is, and what can be done with it, above its values.
import { ArrowLeft, ArrowRight, FolderOpen } from 'lucide-preact';
import { counted } from '../films/durations';
import { goToFrame } from '../motion/clock';
import type { FilmPart } from '../protocol';
import { sequence } from '../state/state';
import { filmClock } from '../strip/clock_text';
import { indexOfPart, movePart, openPart } from './parts';
import './part_tools.css';

/// Where it is in the film, and what of the shot it shows, as sentences.
function About({ part, fps }: { part: FilmPart; fps: number }) {
    const end = part.start + part.frames;
    const ofShot = part.first === 0 && part.frames === part.of_frames ? 'The whole shot.'
        : `Frames ${part.first} to ${part.first + part.frames - 1} of the shot's ${part.of_frames}.`;
    return (
        <p>
            {counted(part.frames, 'frame')}, from{' '}
            <button type="button" class="link" title="Go there" onClick={() => goToFrame(part.start)}>
                {filmClock(part.start / fps)}
            </button> to {filmClock(end / fps)}.{part.kind === 'shot' ? ` ${ofShot}` : ''}
        </p>
    );
}

export function PartTools({ part }: { part: FilmPart }) {
    const index = indexOfPart(part.path);
    const count = sequence.value?.parts.length ?? 0;
    return (
        <div class="part-tools">
            <About part={part} fps={sequence.value?.film.fps ?? 24} />
            <div class="buttons">
                {part.file !== '' ? (
                    <button type="button" title={part.file} onClick={() => openPart(part)}>
                        <FolderOpen size={14} strokeWidth={1.75} aria-hidden="true" />Open shot
                    </button>
                ) : null}
                <button type="button" title="Move it before the part before" disabled={index === 0}
                    onClick={() => movePart(part, -1)}>
                    <ArrowLeft size={14} strokeWidth={1.75} aria-hidden="true" />Earlier
                </button>
                <button type="button" title="Move it behind the next part" disabled={index + 1 >= count}
                    onClick={() => movePart(part, 1)}>
                    <ArrowRight size={14} strokeWidth={1.75} aria-hidden="true" />Later
                </button>
            </div>
        </div>
    );
}
