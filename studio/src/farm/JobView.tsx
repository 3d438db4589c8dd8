/// One job: how far it is, its contact sheet, rate, nodes and frames.
import { withKey } from '../connection/key';
import { FrameStrip, FrameTable } from './FrameTable';
import { frames, jobProblem, list, sheet, shownJob } from './farm_state';
import { memoryText, nameOf, secondsText } from './farm_text';
import type { JobFrames } from './farm_types';
import { NodeTable } from './NodeTable';
import { RateChart } from './RateChart';

function Fact({ name, value }: { name: string; value: string }) {
    return <div><dt>{name}</dt><dd>{value}</dd></div>;
}

function Facts({ job }: { job: JobFrames }) {
    const median = job.median_seconds;
    const memory = Math.max(0, ...job.rows.map(({ memory_bytes }) => memory_bytes ?? 0));
    const workers = job.nodes.reduce((sum, node) => sum + node.workers, 0);
    return (
        <dl class="facts">
            <Fact name="Frames" value={`${job.finished} of ${job.frames}`} />
            <Fact name="Left" value={job.seconds_left === undefined ? '–' : secondsText(job.seconds_left)} />
            <Fact name="Workers" value={String(workers)} />
            <Fact name="A frame takes" value={median > 0 ? secondsText(median) : '–'} />
            <Fact name="Most memory" value={memory > 0 ? memoryText(memory) : '–'} />
        </dl>
    );
}

function Sheet({ job }: { job: JobFrames }) {
    if (sheet.value === 0) {
        return <p class="nothing">{job.finished > 0 ? 'The sheet is being made …' : 'No frame is finished yet.'}</p>;
    }
    const path = withKey(`/sheet/${job.id}.png?${sheet.value}`);
    return <a href={path} target="_blank" rel="noreferrer"><img src={path} alt={`Frames of ${nameOf(job.film)} so far`} /></a>;
}

/// A job that cannot be read, or that the store does not have.
function Unknown() {
    const job = list.value?.jobs.find(({ id }) => id === shownJob.value);
    return (
        <section class="panel">
            <h2>{job ? nameOf(job.film) || job.id : shownJob.value}</h2>
            <p class="nothing">{job?.state === 'unreadable' ? job.message
                : list.value && !job ? 'The store has no such job.'
                    : jobProblem.value ? 'The job cannot be read.' : 'The job is being read …'}</p>
        </section>
    );
}

export function JobView() {
    const job = frames.value;
    return (
        <main aria-label="Job">
            <a class="back" href="#">All jobs</a>
            {!job && <Unknown />}
            {job && (
                <>
                    <section class="panel">
                        <header>
                            <h2>{nameOf(job.film)}</h2>
                            <span class={`state ${job.state}`}>{job.state}</span>
                            <code>{job.id}</code>
                        </header>
                        {job.message && <p class="message">{job.message}</p>}
                        <FrameStrip rows={job.rows} />
                        <Facts job={job} />
                    </section>
                    <section class="panel sheet"><h3>Contact sheet</h3><Sheet job={job} /></section>
                    <section class="panel"><h3>Frames an hour</h3><RateChart rows={job.rows} /></section>
                    <section class="panel"><h3>Nodes</h3><NodeTable nodes={job.nodes} /></section>
                    <section class="panel wide"><h3>Frames</h3><FrameTable rows={job.rows} /></section>
                </>
            )}
        </main>
    );
}
