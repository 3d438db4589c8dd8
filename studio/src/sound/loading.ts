/// Gets the pieces of the film's sound as the server tells that they are there.
import { withKey } from '../connection/key';
import { batch, effect } from '@preact/signals';
import type { SoundState } from '../protocol';
import { soundState } from '../state/state';
import { SoundData } from './sound_data';
import { soundData, soundPieces } from './sound_state';

let wanted: SoundData | null = null; // the one that is got
let isBusy = false;

function dataOf({ address, rate, samples, piece }: SoundState): SoundData {
    return wanted?.address === address ? wanted : new SoundData(address, { rate, samples, piece });
}

/// The first piece that the server has and the page has not.
function nextPiece(data: SoundData): number | null {
    const ready = soundState.peek()?.ready ?? 0;
    const count = Math.ceil(ready / data.extent.piece);
    const index = Array.from({ length: count }, (_, i) => i).find((i) => !data.has(i));
    return index ?? null;
}

/// One piece after the other. A piece that is gone belongs to a film that is over: the server tells
/// the next one.
async function load(): Promise<void> {
    if (isBusy) {
        return;
    }
    isBusy = true;
    try {
        for (let data = wanted; data; data = wanted) {
            const index = nextPiece(data);
            if (index === null) {
                break;
            }
            const answer = await fetch(withKey(`${data.address}${index}.pcm`)).catch(() => null);
            if (answer?.ok) {
                const bytes = await answer.arrayBuffer(); // none of a film that is gone
                if (bytes.byteLength > 0) {
                    data.add(index, new Int16Array(bytes));
                }
            }
            if (data === wanted && !data.has(index)) {
                wanted = null;
            } else if (data === wanted) {
                show(data);
            }
        }
    } finally {
        isBusy = false;
    }
}

function show(data: SoundData): void {
    batch(() => {
        soundData.value = data;
        soundPieces.value += 1;
    });
}

/// Follows what the server tells. Returns a function that ends this.
export function loadSound(): () => void {
    return effect(() => {
        const state = soundState.value;
        if (!state || state.reason) {
            wanted = null;
            soundData.value = null;
            return;
        }
        wanted = dataOf(state);
        void load();
    });
}
