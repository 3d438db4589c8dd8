/// What the path-traced picture of the view shows, as signals.
import { signal } from '@preact/signals';
import type { Picture } from '../../state/state';

/// What is shown of the traced samples. `channel` is that of the message `see`.
export interface ChannelChoice {
    channel: string;
    label: string;
}

export const kChannels: readonly ChannelChoice[] = [
    { channel: '', label: 'Picture' },
    { channel: 'noise', label: 'Noise' },
    { channel: 'depth', label: 'Depth' },
    { channel: 'normal', label: 'Normals' },
    { channel: 'albedo', label: 'Albedo' },
    { channel: 'roughness', label: 'Roughness' },
    { channel: 'object_id', label: 'Objects' },
    { channel: 'material_id', label: 'Materials' },
];

/// Whether the picture is wanted whenever the view rests.
export const isRefining = signal(false);
export const channel = signal('');
/// The newest round of the newest question; null while the view shows something else.
export const shownPicture = signal<Picture | null>(null);
/// The film's frame that it shows; null for a view of its own.
export const shownFrame = signal<number | null>(null);
/// A picture that is kept to compare with, at the left of the line.
export const keptPicture = signal<Picture | null>(null);
/// Where the line between both is, as a fraction of the picture's width.
export const wipe = signal(0.5);
