import { render } from 'preact';
import { Moon, Sun } from 'lucide-preact';
import { takeKeys } from '../connection/key';
import { shownTheme, switchTheme, watchTheme } from '../shell/theme';
import { connect, connection, jobProblem, list, listProblem, shownJob, watchAddress } from './farm_state';
import { JobTable } from './JobTable';
import { JobView } from './JobView';
import './farm.css';

const kConnection = {
    connecting: 'connecting …',
    open: 'up to date',
    lost: 'The connection is lost; trying again …',
    refused: 'The server does not know this page: open the address that carom farm watch has printed.',
};

function App() {
    const isDark = shownTheme.value === 'dark';
    return (
        <div class={shownJob.value ? 'farm with_job' : 'farm'}>
            <header class="top">
                <h1>carom farm</h1>
                <code class="store" title={list.value?.store}>{list.value?.store}</code>
                <span class={`connection ${connection.value}`} role="status">
                    <span class="dot" />{kConnection[connection.value]}
                </span>
                <button type="button" onClick={switchTheme} title={isDark ? 'Light theme' : 'Dark theme'}>
                    {isDark ? <Sun size={16} aria-hidden="true" /> : <Moon size={16} aria-hidden="true" />}
                    <span class="hidden">{isDark ? 'Light theme' : 'Dark theme'}</span>
                </button>
            </header>
            {[listProblem.value, jobProblem.value].map((problem) =>
                problem && <p class="problem" role="alert" key={problem}>{problem}</p>)}
            <div class="body">
                <JobTable />
                {shownJob.value ? <JobView />
                    : <main class="empty"><p class="nothing">Choose a job to see its frames.</p></main>}
            </div>
        </div>
    );
}

const app = document.getElementById('app');
if (app) {
    takeKeys();
    watchTheme();
    watchAddress();
    render(<App />, app);
    connect();
}
