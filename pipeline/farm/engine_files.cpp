#include "pipeline/farm/engine_files.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <map>
#include <span>

#include <fmt/core.h>

#include "core/atomic_file.h"
#include "core/json_text.h"
#include "pipeline/farm/engine.h"
#include "pipeline/farm/scripts.h"
#include "pipeline/farm/shell_text.h"

namespace carom::farm {
namespace {

std::string film_name(const FarmJob& job) {
    return std::filesystem::path(job.film).stem().string();
}

/// The job's name as a label of DNS (RFC 1123), which names in Kubernetes have to be. The engine
/// adds up to 23 letters for each pod.
std::string dns_name(const FarmJob& job) {
    std::string name = simple_name(film_name(job), 27);
    std::ranges::transform(name, name.begin(), [](unsigned char letter) {
        return letter == '_' ? '-' : static_cast<char>(std::tolower(letter));
    });
    const std::size_t end = name.find_last_not_of('-');
    return "carom-" + (end == std::string::npos ? "film" : name.substr(0, end + 1)) +
           (job.id.empty() ? "" : "-" + job.id);
}

std::int64_t at_once(const FarmJob& job) {
    return job.tasks_at_once > 0 ? std::min(job.tasks_at_once, job.workers) : job.workers;
}

EngineFiles slurm_files(const FarmJob& /*job*/) {
    return {{{"submit.sh",
              "#!/bin/sh\n"
              "# Submits the film to Slurm.\n"
              "cd \"$(dirname \"$0\")\" || exit 1\n"
              "exec \"${CAROM:-carom}\" farm resume .\n",
              true}},
            "submit.sh",
            "./submit.sh",
            ""};
}

EngineFiles parallel_files(const FarmJob& job) {
    return {
        {{"run.sh",
          fmt::format(
              "#!/bin/sh\n"
              "# Renders the film with GNU parallel. JOBS: workers at a time; unless it is set, "
              "as many as there are processors\n"
              "# ({} for each) and memory ({} MB for each).\n"
              "cd \"$(dirname \"$0\")\" || exit 1\n"
              "jobs=$(($(nproc) / {}))\n"
              "most=$(awk '/^MemAvailable:/ {{print int($2 / {})}}' /proc/meminfo)\n"
              "[ \"$jobs\" -le \"$most\" ] || jobs=$most\n"
              "[ \"$jobs\" -ge 1 ] || jobs=1\n"
              "while :; do\n"
              "  seq {} | parallel --jobs \"${{JOBS:-$jobs}}\" -N0 ./worker.sh\n"
              "  ./film.sh && exit 0\n"
              "  [ $? -eq 75 ] || exit 1  # 75: frames are missing, and the last round added "
              "some\n"
              "done\n",
              job.processors, job.memory, job.processors,
              std::max<std::int64_t>(1, job.memory * 1000000 / 1024), job.workers),
          true}},
        "run.sh",
        "./run.sh",
        ""};
}

// The fields are those of io.k8s.api.batch.v1.Job.
constexpr const char* kKubernetesJob =
    R"(# A film as an Indexed Job of the API batch/v1 (Kubernetes 1.29 or later):
# https://kubernetes.io/docs/reference/kubernetes-api/workload-resources/job-v1/
# The worker that completes the film writes it; then all others end, too.
apiVersion: batch/v1
kind: Job
metadata:
  name: {name}
spec:
  completionMode: Indexed
  completions: {workers}
  parallelism: {at_once}
  backoffLimitPerIndex: 20
  podFailurePolicy:
    rules:
      # Wrong input stays wrong.
      - action: FailJob
        onExitCodes: {{containerName: worker, operator: In, values: [2]}}
      # A worker that has to leave its node puts its frame down, and begins again elsewhere.
      - action: Ignore
        onPodConditions: [{{type: DisruptionTarget, status: "True"}}]
  template:
    spec:
      restartPolicy: Never
      terminationGracePeriodSeconds: {grace}
      # Without root, as the owner of this folder; the file system of the volume decides who that is.
      # securityContext: {{runAsNonRoot: true, runAsUser: 1000, runAsGroup: 1000, fsGroup: 1000}}
      containers:
        - name: worker
          image: carom  # from container/Containerfile
          command: [/job/worker.sh]
          # For shots with view: ocio; the configuration has to be in the image or in a volume.
          # env: [{{name: OCIO, value: /job/config.ocio}}]
          resources:
            requests: {{cpu: "{processors}", memory: {memory}M}}
            limits: {{memory: {memory}M}}
          volumeMounts:
            - {{name: job, mountPath: /job}}
      volumes:
        - name: job
          persistentVolumeClaim: {{claimName: {name}}}  # ReadWriteMany, with this folder
)";

EngineFiles kubernetes_files(const FarmJob& job) {
    return {{{"job.yaml",
              fmt::format(kKubernetesJob, fmt::arg("name", dns_name(job)),
                          fmt::arg("workers", job.workers), fmt::arg("at_once", at_once(job)),
                          fmt::arg("grace", 2 * kGrace), fmt::arg("processors", job.processors),
                          fmt::arg("memory", job.memory)),
              false}},
            "job.yaml",
            "kubectl replace --force -f job.yaml",
            fmt::format("The folder has to be in a volume that all nodes can write to (access mode "
                        "ReadWriteMany),\nwhose claim has the name `{}`. The image `carom` is made "
                        "from `container/Containerfile`.\nIts workers are root in their container "
                        "unless the line securityContext in `job.yaml` names the\nowner of the "
                        "folder. Said again, the command starts the job again.\n\n",
                        dns_name(job))};
}

/// Of the task of a step: the job's folder, the program, and more words.
std::string openjd_action(const std::string& command, const std::string& more) {
    return fmt::format(R"(    script:
      actions:
        onRun:
          command: /bin/sh
          args: ["-c", {}, carom, "{{{{Param.JobFolder}}}}", "{{{{Param.Carom}}}}"{}]
          cancelation: {{mode: NOTIFY_THEN_TERMINATE, notifyPeriodInSeconds: {}}}
)",
                       json_string(command), more, kGrace);
}

// The specification: OpenJobDescription/openjd-specifications, wiki/2023-09-Template-Schemas.md.
constexpr const char* kOpenjdTemplate =
    R"(# A film as a template of Open Job Description, version 2023-09:
# https://github.com/OpenJobDescription/openjd-specifications/wiki/2023-09-Template-Schemas
specificationVersion: jobtemplate-2023-09
name: {name}
parameterDefinitions:
  - name: JobFolder
    type: PATH
    objectType: DIRECTORY
    dataFlow: NONE
    default: .
    description: The folder of this template, which all hosts see.
  - name: Carom
    type: STRING
    default: carom
    description: The program.
steps:
  - name: Frames
    hostRequirements:
      amounts:
        - {{name: amount.worker.vcpu, min: {processors}}}
        - {{name: amount.worker.memory, min: {mebibytes}}}
    parameterSpace:
      taskParameterDefinitions:
        - {{name: Worker, type: INT, range: "0-{last}"}}
{frames}  - name: Film
    dependencies: [{{dependsOn: Frames}}]
    hostRequirements:
      amounts:
        - {{name: amount.worker.vcpu, min: {processors}}}
        - {{name: amount.worker.memory, min: {mebibytes}}}
{film})";

EngineFiles openjd_files(const FarmJob& job) {
    constexpr std::int64_t kMebibyte = 1048576;
    const std::string film = openjd_action(R"(cd "$1" && CAROM="$2" exec ./film.sh)", "");
    const std::string frames =
        openjd_action(R"(cd "$1" && CAROM="$2" CAROM_TASK="$3" exec ./worker.sh)",
                      R"(, "{{Task.Param.Worker}}")");
    return {
        {{"template.yaml",
          fmt::format(kOpenjdTemplate, fmt::arg("name", json_string(simple_name(film_name(job)))),
                      fmt::arg("processors", job.processors),
                      fmt::arg("mebibytes", (job.memory * 1000000 + kMebibyte - 1) / kMebibyte),
                      fmt::arg("last", job.workers - 1), fmt::arg("frames", frames),
                      fmt::arg("film", film)),
          false}},
        "template.yaml",
        "openjd run template.yaml --step Film --run-dependencies",
        "A render manager takes template.yaml as it is, for example Deadline Cloud. All hosts have "
        "to see the\nfolder, whose path is the parameter JobFolder.\n\n"};
}

// A name without a value is a variable that qsub takes from its own environment, with whatever is
// in it; one that is not there would be refused.
constexpr const char* kPbsSubmission =
    R"sh(#!/bin/sh
# Submits the film to PBS (qsub of OpenPBS or PBS Professional): an array of workers, and the task that
# writes the film when they have ended. They get these variables, and those that CAROM_FARM_VARIABLES
# names.
cd "$(dirname "$0")" || exit 1
export CAROM="${{CAROM:-carom}}"
names=CAROM
for name in PATH LD_LIBRARY_PATH XDG_CACHE_HOME KRB5CCNAME CAROM_CACHE CAROM_CACHE_SIZE CAROM_CONFIGS \
    CAROM_LAB CAROM_LIMITS OCIO $CAROM_FARM_VARIABLES; do
  printenv "$name" > /dev/null && names="$names,$name"
done
workers=$(qsub -N {name}-frames {array}{time} -r y -j oe -o logs/ -v "$names"{options} worker.sh) || exit 1
qsub -N {name}-film -W depend=afterany:"$workers" {film_time} -j oe -o logs/ -v "$names"{options} task.sh ||
  {{ qdel "$workers"; exit 1; }}
)sh";

/// qsub of OpenPBS and PBS Professional; an array needs at least two tasks there.
EngineFiles pbs_files(const FarmJob& job) {
    const auto limits = [&](std::int64_t minutes) {
        return fmt::format("-l select=1:ncpus={}:mem={}mb -l walltime={:02}:{:02}:00",
                           job.processors, job.memory, minutes / 60, minutes % 60);
    };
    std::string options;
    if (!job.partition.empty()) {
        options += " -q " + shell_word(job.partition);
    }
    if (!job.account.empty()) {
        options += " -A " + shell_word(job.account);
    }
    if (job.priority != 0) {
        options += fmt::format(" -p {}", std::clamp<std::int64_t>(job.priority, -1024, 1023));
    }
    for (const std::string& option : job.engine_options) {
        options += " " + shell_word(option);
    }
    const std::string name = simple_name(film_name(job), 8);
    const std::string array =
        job.workers > 1
            ? fmt::format("-J 0-{}{} ", job.workers - 1,
                          job.tasks_at_once > 0 ? fmt::format("%{}", job.tasks_at_once) : "")
            : std::string();
    return {
        {{"submit.sh",
          fmt::format(kPbsSubmission, fmt::arg("name", name), fmt::arg("array", array),
                      fmt::arg("time", limits(job.time)),
                      fmt::arg("film_time", limits(job.film_time)), fmt::arg("options", options)),
          true},
         {"task.sh",
          "#!/bin/sh\n"
          "# Writes the film, or submits the workers again (75: frames are missing, and the last "
          "round added some).\n" +
              std::string(kGoToFolder) +
              "./film.sh\n"
              "code=$?\n"
              "[ $code -ne 75 ] || exec ./submit.sh\n"
              "exit $code\n",
          true}},
        "submit.sh",
        "./submit.sh",
        ""};
}

}  // namespace

EngineFiles engine_files(const FarmJob& job) {
    static const std::map<std::string, EngineFiles (*)(const FarmJob&)> all{
        {"slurm", slurm_files},
        {"parallel", parallel_files},
        {"k8s", kubernetes_files},
        {"openjd", openjd_files},
        {"pbs", pbs_files}};
    return all.at(job.engine)(job);
}

void write_engine_file(const FarmJob& job, const EngineFile& file) {
    if (file.is_script) {
        return write_script(job, file.name, file.text);
    }
    write_file_atomically(job.folder + "/" + file.name, std::as_bytes(std::span(file.text)));
}

EngineFile container_file() {
    return {
        "container/Containerfile",
        "# A container with carom, Containerfile(5). Put the package beside this file ('cpack -G "
        "DEB' makes it in\n"
        "# build/package), then 'podman build -t carom container', or 'docker build -t carom -f "
        "container/Containerfile\n"
        "# container'.\n"
        "FROM docker.io/library/debian:12-slim\n"
        "COPY carom_*.deb /tmp/\n"
        "RUN apt-get update && apt-get install --yes --no-install-recommends /tmp/carom_*.deb && "
        "rm -rf /tmp/carom_*.deb /var/lib/apt/lists/*\n"
        "WORKDIR /job\n"
        "ENTRYPOINT [\"carom\"]\n",
        false};
}

}  // namespace carom::farm
