/// The loudspeaker and the volume, on the bar of time.
import { Volume1, Volume2, VolumeX } from 'lucide-preact';
import { hintOf, runCommand } from '../state/keys';
import { isMuted, soundNote, volume } from './sound_state';
import './sound.css';

export function SoundTools() {
    const note = soundNote.value;
    const isSilent = note !== '' || isMuted.value || volume.value === 0;
    const Icon = isSilent ? VolumeX : volume.value < 0.5 ? Volume1 : Volume2;
    return (
        <div class="sound-tools">
            <button type="button" class="loudspeaker" title={note || hintOf('mute')}
                aria-label={note || 'Sound'} aria-pressed={note === '' && !isMuted.value}
                aria-disabled={note !== ''} onClick={() => runCommand('mute')}>
                <Icon size={15} strokeWidth={1.75} aria-hidden="true" />
            </button>
            <input type="range" class="volume" aria-label="Volume" title="Volume" min={0} max={1}
                step={0.05} value={isMuted.value ? 0 : volume.value} disabled={note !== ''}
                onInput={(event) => {
                    volume.value = event.currentTarget.valueAsNumber;
                    isMuted.value = false;
                }} />
        </div>
    );
}
