/// What stands in the place of the view for a film of several shots: the picture of the film's frame at
/// the play head. While it plays, and until the picture comes, the nearest small picture of the film
/// that was made, else the name of the part.
import { withKey } from '../connection/key';
import { effect } from '@preact/signals';
import { Aperture, Download, FolderOpen } from 'lucide-preact';
import { useEffect, useLayoutEffect, useRef } from 'preact/hooks';
import type { FilmPart } from '../protocol';
import { onCommand, runCommand } from '../state/keys';
import { filmThumbnails } from '../state/film_thumbnails';
import { pictureAsked, sequence } from '../state/state';
import { Menu } from '../view/menu/Menu';
import { followShown, isPictureOld } from '../view/picture/asking';
import { channel, isRefining, shownPicture } from '../view/picture/picture_state';
import { drawOn, savePicture } from '../view/picture/save_picture';
import { openPart, partAt, shownFrame, shownPart } from './parts';
import '../view/picture/picture_bar.css';
import './sequence_view.css';

const kSamples = 16; // of a picture to look at; the film has its own number
const kNearest = 12; // frames: a small picture that is farther away is not shown

/// Keeps the picture that of the frame at the play head, as long as the view is there.
function useTracedFrame(): void {
    useEffect(() => {
        const before = [isRefining.peek(), channel.peek()] as const;
        isRefining.value = true;
        channel.value = '';
        const endings = [
            followShown(() => sequence.value
                ? { frame: shownFrame.value, width: 0, height: 0, samples: kSamples } : null),
            onCommand('refine', () => { isRefining.value = !isRefining.peek(); }),
        ];
        return () => {
            endings.forEach((end) => end());
            [isRefining.value, channel.value] = before;
        };
    }, []);
}

function Traced() {
    const canvas = useRef<HTMLCanvasElement>(null);
    // Before the browser paints, so that nobody sees the canvas without the picture.
    useLayoutEffect(() => effect(() => {
        const [element, picture] = [canvas.current, shownPicture.value];
        if (element && picture) {
            drawOn(element, picture);
        }
    }), []);
    return <canvas ref={canvas} role="img" aria-label="The frame of the film" class={isPictureOld() ? 'old' : ''} />;
}

/// The address of the small picture nearest to the frame, of the same part; empty if there is none.
function thumbnailNear(parts: readonly FilmPart[], frame: number): string {
    const part = partAt(parts, frame);
    for (let away = 0; away <= kNearest; away += 1) {
        for (const one of [frame - away, frame + away]) {
            const address = filmThumbnails.value.get(one);
            if (address && partAt(parts, one) === part) {
                return address;
            }
        }
    }
    return '';
}

function Card({ part }: { part: FilmPart }) {
    return (
        <div class="card">
            <h2>{part.name}</h2>
            {part.file !== '' ? (
                <button type="button" onClick={() => openPart(part)}>
                    <FolderOpen size={15} strokeWidth={1.75} aria-hidden="true" />Open shot
                </button>
            ) : null}
        </div>
    );
}

/// Which part is shown, and how far its picture is.
function Bar({ part }: { part: FilmPart | undefined }) {
    const head = shownPicture.value?.head;
    const progress = !head ? pictureAsked.value ? 'Tracing …' : ''
        : isPictureOld() ? 'out of date'
            : head.of_samples > 0 ? `${head.samples} of ${head.of_samples} samples` : '';
    return (
        <div class="picture-bar" role="group" aria-label="Path-traced picture">
            <button class="tool" aria-label="Traced" aria-pressed={isRefining.value} disabled={!sequence.value}
                title="Show the path-traced picture of the frame (R)" onClick={() => runCommand('refine')}>
                <Aperture size={15} aria-hidden="true" /> <span>Traced</span>
            </button>
            {part && part.file !== '' ? (
                <button class="tool" aria-label="Open shot" title={`Open ${part.file}`} onClick={() => openPart(part)}>
                    <FolderOpen size={15} aria-hidden="true" /> <span>Open shot</span>
                </button>
            ) : null}
            <button class="tool" aria-label="Save the picture" disabled={!shownPicture.value} title="Save the picture as PNG"
                onClick={() => shownPicture.value && savePicture(shownPicture.value)}>
                <Download size={15} aria-hidden="true" /> <span>Save</span>
            </button>
            <span class="progress" role="status">{progress}</span>
        </div>
    );
}

export function SequenceView() {
    useTracedFrame();
    const parts = sequence.value?.parts ?? [];
    const part = parts[shownPart.value];
    const small = shownPicture.value ? '' : thumbnailNear(parts, shownFrame.value);
    return (
        <div class="sequence-view" role="region" aria-label="The film">
            <div class="frame">
                {shownPicture.value ? <Traced />
                    : small ? <img src={withKey(small)} alt="The frame of the film" />
                        : part ? <Card part={part} /> : null}
            </div>
            <Bar part={part} />
            <Menu />
        </div>
    );
}
