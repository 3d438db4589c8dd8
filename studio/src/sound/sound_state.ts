/// The film's sound as the page knows it, and how loud it is; the latter is remembered by the browser.
import { computed, signal } from '@preact/signals';
import { sequence, soundState, timeline } from '../state/state';
import { SoundData } from './sound_data';

/// The samples that have come; null: there are none yet, or the film is silent.
export const soundData = signal<SoundData | null>(null);
/// Counts the pieces that came.
export const soundPieces = signal(0);

/// Why there is nothing to hear, a sentence for people; empty: there is sound.
export const soundNote = computed(() =>
    soundState.value?.reason ? `No sound: ${soundState.value.reason}.`
        : soundData.value ? '' : 'The sound is computed after the simulation.');

/// Whether the strip has a row for the sound: unless the film is known to have none.
export const hasSoundRow = computed(() => !soundState.value?.reason);

/// Whether the sound is that of an older version than the motion.
export const isSoundStale = computed(() => {
    const shown = sequence.value?.v ?? timeline.value?.head.v ?? 0;
    return (soundState.value?.v ?? 0) < shown;
});

function remembered(name: string, usual: number): number {
    const stored = Number.parseFloat(localStorage.getItem(name) ?? '');
    return stored >= 0 && stored <= 1 ? stored : usual;
}

/// Where the slider stands, in [0, 1].
export const volume = signal(remembered('carom.sound.volume', 0.8));
export const isMuted = signal(localStorage.getItem('carom.sound.muted') === 'yes');
volume.subscribe((value) => localStorage.setItem('carom.sound.volume', String(value)));
isMuted.subscribe((value) => localStorage.setItem('carom.sound.muted', value ? 'yes' : 'no'));

/// The factor of the sound pressure. The square of the slider: half of its way is a quarter.
export const gain = computed(() => isMuted.value ? 0 : volume.value ** 2);

/// Sound on or off, if there is any.
export function toggleMute(): void {
    if (soundNote.peek() === '') {
        isMuted.value = !isMuted.peek();
    }
}
