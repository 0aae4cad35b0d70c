#ifndef LATTICEWORLD_CAMPAIGN_WORKERS_SLURM_JOB_H_
#define LATTICEWORLD_CAMPAIGN_WORKERS_SLURM_JOB_H_

#include <filesystem>
#include <string>

namespace latticeworld {

struct SlurmJob {
  std::string name;                 // of the campaign
  std::filesystem::path program;    // absolute
  std::filesystem::path file, out;  // absolute: the campaign's file and its folder
  int shards = 1;                   // tasks of the array
  int workers = 1;                  // processes, and so cores, of each
};

// Text of a job file: `sbatch FILE` runs the shards as an array, each of them resumable, and makes
// tables and report in a job that depends on all of them. Run by bash without Slurm it does the
// same one after the other.
std::string SlurmJobFile(const SlurmJob& job);

}  // namespace latticeworld

#endif  // LATTICEWORLD_CAMPAIGN_WORKERS_SLURM_JOB_H_
