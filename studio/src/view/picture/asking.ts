/// Asks the server for the traced picture of what is shown, and takes its rounds.
import { batch, effect, signal } from '@preact/signals';
import { send } from '../../connection/socket';
import {
    connection, isStale, picture, pictureAsked, playing, sequence, shot, timeline, waitsForButton, welcome,
} from '../../state/state';
import { channel, isRefining, shownFrame, shownPicture } from './picture_state';
import type { Shown } from './question';

let question = 0;
/// The number of the question that the server answers; 0: none.
const openQuestion = signal(0);

/// Whether the page is seen at all: nobody looks at the pictures of a hidden one.
const isPageSeen = signal(true);

function watchPage(): () => void {
    const changed = () => { isPageSeen.value = document.visibilityState !== 'hidden'; };
    document.addEventListener('visibilitychange', changed);
    changed();
    return () => document.removeEventListener('visibilitychange', changed);
}

/// Asks for what is shown, once for each change.
function ask(wanted: Shown | null): void {
    question += 1;
    shownPicture.value = null;
    shownFrame.value = wanted?.frame ?? null;
    const isAsked = wanted !== null
        ? send('see', {
            q: question, v: (shot.peek() ?? sequence.peek())?.v ?? 0, samples: 0, channel: channel.peek(), ...wanted,
        })
        : send('unsee', {}) && false;
    openQuestion.value = isAsked ? question : 0;
}

/// Whether the picture belongs to older texts than the motion. The server makes it anew by itself.
function isBehindMotion(): boolean {
    const newest = sequence.value?.v ?? timeline.value?.head.v ?? 0;
    return (shownPicture.value?.head.v ?? Infinity) < newest;
}

/// Whether the shown picture is not that of the newest texts.
export function isPictureOld(): boolean {
    return isStale.value || isBehindMotion();
}

/// Whether a picture will come.
function isAwaited(): boolean {
    const isDone = (shownPicture.value?.head.complete ?? false) && !isBehindMotion();
    return openQuestion.value > 0 && !waitsForButton.value && !isDone;
}

function canAsk(): boolean {
    return isRefining.value && !playing.value && isPageSeen.value && connection.value === 'open'
        && (shot.value ?? sequence.value) !== null;
}

/// Keeps `shownPicture` that of what `shown` returns, until the returned function is called.
export function followShown(shown: () => Shown | null): () => void {
    let asked = '';
    const ends = [
        watchPage(),
        effect(() => {
            const wanted = canAsk() ? shown() : null;
            const key = JSON.stringify([wanted, channel.value, welcome.value?.shot]);
            const isNew = key !== asked && (wanted !== null || question > 0);
            asked = key;
            if (isNew) {
                batch(() => ask(wanted));
            }
        }),
        effect(() => {
            const one = picture.value;
            if (one && one.head.q === openQuestion.peek()) {
                shownPicture.value = one;
            }
        }),
        effect(() => { pictureAsked.value = isAwaited(); }),
    ];
    return () => {
        ends.forEach((end) => end());
        if (openQuestion.peek() > 0) {
            batch(() => ask(null));
        }
        pictureAsked.value = false;
    };
}
