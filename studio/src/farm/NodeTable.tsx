/// The nodes of a job, the ones with failures first.
import { countText } from './farm_text';
import type { NodeRow } from './farm_types';

export function NodeTable({ nodes }: { nodes: NodeRow[] }) {
    if (nodes.length === 0) {
        return <p class="nothing">No worker has begun yet.</p>;
    }
    const sorted = [...nodes].sort((a, b) => b.failures - a.failures || b.rendered - a.rendered);
    return (
        <div class="scroll" tabIndex={0} role="region" aria-label="Nodes">
            <table>
                <thead>
                    <tr><th>Node</th><th class="number">Workers</th><th class="number">Frames</th>
                        <th class="number">An hour</th><th class="number">Failures</th></tr>
                </thead>
                <tbody>
                    {sorted.map((one) => (
                        <tr key={one.node}>
                            <th scope="row">{one.node || 'unknown'}</th>
                            <td class="number">{one.workers}</td>
                            <td class="number">{one.rendered}</td>
                            <td class="number">{one.frames_per_hour === undefined ? '' : countText(one.frames_per_hour)}</td>
                            <td class={`number ${one.failures > 0 ? 'bad' : ''}`}>{one.failures}</td>
                        </tr>
                    ))}
                </tbody>
            </table>
        </div>
    );
}
