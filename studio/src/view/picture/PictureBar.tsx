/// The tools of the path-traced picture, at the lower edge of the view.
import { Aperture, Download, SquareSplitHorizontal, X } from 'lucide-preact';
import { send } from '../../connection/socket';
import { deferred, pictureAsked, shot, waitsForButton } from '../../state/state';
import { runCommand } from '../../state/keys';
import {
    channel, isRefining, kChannels, keptPicture, shownPicture, wipe,
} from './picture_state';
import { isPictureOld } from './asking';
import { savePicture } from './save_picture';
import './picture_bar.css';

/// How far the picture is, as a sentence.
function progressText(): string {
    const head = shownPicture.value?.head;
    if (!head) {
        return pictureAsked.value ? 'Tracing …' : '';
    }
    if (head.complete) {
        return `${head.samples} ${head.samples === 1 ? 'sample' : 'samples'}${head.stored ? ', kept for the film' : ''}`;
    }
    return `${head.samples} of ${head.of_samples} samples`;
}

function Progress() {
    const waits = deferred.value;
    return waitsForButton.value && waits ? (
        <span class="progress" role="status">
            The motion has not been simulated yet.{' '}
            <button class="link" onClick={() => send('simulate', { v: waits.v })}>Simulate it</button>
        </span>
    ) : (
        <span class="progress" role="status">
            {shownPicture.value && isPictureOld() ? 'out of date' : progressText()}
        </span>
    );
}

function Compare() {
    const kept = keptPicture.value;
    if (!kept) {
        return (
            <button class="tool" disabled={!shownPicture.value}
                title="Keep this picture, to compare the next ones with it"
                onClick={() => { keptPicture.value = shownPicture.value; }}>
                <SquareSplitHorizontal size={15} aria-hidden="true" /> Compare
            </button>
        );
    }
    return (
        <label class="compare" title="Left of the line is the kept picture">
            <span>Before</span>
            <input type="range" min="0" max="1" step="0.005" value={wipe.value}
                aria-label="Place of the line between the kept and the new picture"
                onInput={(event) => { wipe.value = Number(event.currentTarget.value); }} />
            <span>After</span>
            <button class="tool" title="End the comparison" aria-label="End the comparison"
                onClick={() => { keptPicture.value = null; }}>
                <X size={14} aria-hidden="true" />
            </button>
        </label>
    );
}

export function PictureBar() {
    const isOn = isRefining.value;
    const head = shownPicture.value?.head;
    return (
        <div class="picture-bar" role="group" aria-label="Path-traced picture">
            <button class="tool" aria-pressed={isOn} disabled={!shot.value}
                title="Show the path-traced picture of this view (R)"
                onClick={() => runCommand('refine')}>
                <Aperture size={15} aria-hidden="true" /> Traced
            </button>
            {isOn && (
                <>
                    <select aria-label="What the picture shows" value={channel.value}
                        onChange={(event) => { channel.value = event.currentTarget.value; }}>
                        {kChannels.map((one) => (
                            <option key={one.channel} value={one.channel}>{one.label}</option>
                        ))}
                    </select>
                    <Compare />
                    <button class="tool" disabled={!shownPicture.value} title="Save the picture as PNG"
                        onClick={() => shownPicture.value && savePicture(shownPicture.value)}>
                        <Download size={15} aria-hidden="true" /> Save
                    </button>
                    <Progress />
                    {head?.legend ? <span class="legend">{head.legend}</span> : null}
                    {head && !head.complete
                        ? <progress max={head.of_samples} value={head.samples} /> : null}
                </>
            )}
        </div>
    );
}
