#!/bin/sh
# SPDX-License-Identifier: MIT
# A Slurm job array: each task renders FRAMES frames of a recipe, and is queued again if its node fails. For 1,000 frames in
# tasks of 50:
#   sbatch --array=0-19 samples/dataset/slurm.sh RECIPE OUTPUT 50
# RECIPE and OUTPUT are on a file system that all nodes share, as are NICOL_LIBRARY and PYTHONPATH, if the package is not
# installed on the nodes.
#SBATCH --job-name=nicol-dataset
#SBATCH --requeue
set -eu
first=$((SLURM_ARRAY_TASK_ID * $3))
exec "${PYTHON:-python3}" -m nicol.dataset "$1" --frames "$first:$((first + $3))" --output "$2" --threads "${SLURM_CPUS_ON_NODE:-0}"
