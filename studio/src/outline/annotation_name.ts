/// What annotations are called, and the texts that they write, for people.
import type { ShotAnnotation } from '../protocol';

/// "path of cue", "ghost of cue on one", "angle of cue, one", "text".
export function annotationName({ kind, subject }: Pick<ShotAnnotation, 'kind' | 'subject'>): string {
    const names = kind === 'ghost' || kind === 'tangent' ? subject.replace(', ', ' on ') : subject;
    return names === '' ? kind : `${kind} of ${names}`;
}

/// A text without its values, which only frames have: "{cue.speed:.1f} m/s" is "… m/s".
export function withoutValues(text: string): string {
    return text.replace(/\{\{|\}\}|\{[^}]*\}/g, (found) =>
        found === '{{' ? '{' : found === '}}' ? '}' : '…');
}
