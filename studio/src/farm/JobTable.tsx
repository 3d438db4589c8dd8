/// All jobs of the store.
import { nameOf, secondsText } from './farm_text';
import { list, shownJob } from './farm_state';
import type { Job } from './farm_types';

/// The part that is done, as a bar of a hundred units.
export function Bar({ done, all }: { done: number; all: number }) {
    const share = all > 0 ? (100 * done) / all : 0;
    return (
        <svg class="bar" viewBox="0 0 100 4" preserveAspectRatio="none" role="img"
            aria-label={`${Math.floor(share)} % done`}>
            <rect class="rest" width="100" height="4" />
            <rect class="done" width={share} height="4" />
        </svg>
    );
}

function Row({ job }: { job: Job }) {
    const isReadable = job.state !== 'unreadable';
    return (
        <li>
            <a href={`#${encodeURIComponent(job.id)}`} class="job" title={job.film || job.folder}
                aria-current={job.id === shownJob.value ? 'true' : undefined}>
                <span class="name">{nameOf(job.film) || job.id}</span>
                <span class={`state ${job.state}`}>{job.state}</span>
                {isReadable && <Bar done={job.finished} all={job.frames} />}
                <span class="facts">
                    {isReadable && <span>{job.finished} of {job.frames}</span>}
                    {job.seconds_left !== undefined && <span>{secondsText(job.seconds_left)} left</span>}
                    <span class="spring" />
                    <span>{job.owner}</span>
                </span>
                {job.message && <span class="message">{job.message}</span>}
            </a>
        </li>
    );
}

export function JobTable() {
    const jobs = list.value?.jobs;
    return (
        <nav class="jobs" aria-label="Jobs">
            <h2>Jobs {jobs && <span class="count">{jobs.length}</span>}</h2>
            {jobs?.length === 0 && <p class="nothing">The store has no job. <code>carom farm submit</code> makes one.</p>}
            {!jobs && <p class="nothing">The store is being read …</p>}
            <ul>{jobs?.map((job) => <Row key={job.id} job={job} />)}</ul>
        </nav>
    );
}
