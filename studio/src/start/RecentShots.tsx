/// The shots that were opened last.
import { withKey } from '../connection/key';
import { X } from 'lucide-preact';
import { send } from '../connection/socket';
import type { StartFile } from '../protocol';
import { openShot } from './file_actions';

/// The folder of a file.
function folderOf(file: string): string {
    return file.slice(0, file.lastIndexOf('/')) || '/';
}

function Recent({ shot }: { shot: StartFile }) {
    return (
        <li>
            <button type="button" class="recent" title={shot.file}
                onClick={() => { void openShot(shot.file); }}>
                <span class="thumb">
                    {shot.still ? <img src={withKey(shot.still)} alt="" draggable={false} /> : null}
                </span>
                <span class="words">
                    <span class="name">{shot.name}</span>
                    <span class="folder"><bdi>{folderOf(shot.file)}</bdi></span>
                </span>
            </button>
            <button type="button" class="forget" aria-label={`Forget ${shot.name}`}
                title="Take it from this list; the file stays"
                onClick={() => { send('forget', { file: shot.file }); }}>
                <X size={14} aria-hidden="true" />
            </button>
        </li>
    );
}

export function RecentShots({ shots }: { shots: readonly StartFile[] }) {
    return (
        <section class="recents" aria-label="Recent shots">
            <h2>Recent</h2>
            {shots.length === 0
                ? <p class="empty">Shots that you open are listed here.</p>
                : <ul>{shots.map((shot) => <Recent key={shot.file} shot={shot} />)}</ul>}
        </section>
    );
}
