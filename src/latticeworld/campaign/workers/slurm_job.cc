#include "latticeworld/campaign/workers/slurm_job.h"

namespace latticeworld {
namespace {

// One word for a shell, whatever is in it.
std::string ShellWord(const std::string& text) {
  std::string word = "'";
  for (const char letter : text)
    word += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
  return word + "'";
}

// A name that job lists show: letters of other kinds become dashes.
std::string JobName(const std::string& text) {
  std::string name;
  for (const char letter : text.substr(0, 40)) {
    const bool plain = (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') ||
                       (letter >= '0' && letter <= '9');
    name += plain ? letter : '-';
  }
  return name.empty() ? "campaign" : name;
}

}  // namespace

std::string SlurmJobFile(const SlurmJob& job) {
  const std::string shards = std::to_string(job.shards);
  const std::string workers = std::to_string(job.workers);
  return "#!/bin/bash\n"
         "#SBATCH --job-name=" +
         JobName(job.name) +
         "\n"
         "#SBATCH --array=0-" +
         std::to_string(job.shards - 1) +
         "\n"
         "#SBATCH --ntasks=1\n"
         "#SBATCH --cpus-per-task=" +
         workers +
         "\n"
         "#SBATCH --requeue\n"
         "# Each task of the array runs one shard; the first also hands in the job that merges.\n"
         "# Handed in again after a breakdown, it runs what has no result yet.\n"
         "set -euo pipefail\n"
         "campaign=(" +
         ShellWord(job.program.string()) + " campaign " + ShellWord(job.file.string()) +
         "\n"
         "  --out " +
         ShellWord(job.out.string()) +
         " --resume)\n"
         "shard() { \"${campaign[@]}\" --shard \"$1/" +
         shards + "\" --workers " + workers +
         "; }\n"
         "if [ -z \"${SLURM_ARRAY_TASK_ID:-}\" ]; then\n"
         "  for ((i = 0; i < " +
         shards +
         "; ++i)); do shard \"$i\"; done\n"
         "  exec \"${campaign[@]}\" --merge\n"
         "fi\n"
         "if [ \"$SLURM_ARRAY_TASK_ID\" -eq 0 ] && [ \"${SLURM_RESTART_COUNT:-0}\" -eq 0 ]; then\n"
         "  sbatch --dependency=\"afterany:${SLURM_ARRAY_JOB_ID}\" --ntasks=1 --job-name=merge \\\n"
         "    --wrap \"$(printf '%q ' \"${campaign[@]}\" --merge)\"\n"
         "fi\n"
         "shard \"$SLURM_ARRAY_TASK_ID\"\n";
}

}  // namespace latticeworld
