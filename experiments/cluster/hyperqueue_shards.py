#!/usr/bin/env python3
"""Shards as tasks of one HyperQueue job: on the server in HQ_SERVER_DIR, or else on WORKERS workers of this machine.
Options of `reproduce` follow the name of this script; what a task complains about stands beside its shard."""
import os
import sys
from hyperqueue import Client, Job, LocalCluster
from hyperqueue.cluster import WorkerConfig

value, server = os.environ.get, os.environ.get("HQ_SERVER_DIR")
count, program, out = int(value("SHARDS", "16")), os.environ["ZONOBENCH"], os.path.abspath(os.environ["OUT"])
os.makedirs(out, exist_ok=True)
cluster = None if server else LocalCluster()
for _ in range(0 if cluster is None else int(value("WORKERS", "2"))):
    cluster.start_worker(WorkerConfig(cores=1))
job, client = Job(max_fails=None), Client(server) if cluster is None else cluster.client()
for i in range(count):
    words = ["reproduce", "--profile", value("PROFILE", "full"), "--threads", "1", "--out", out, *sys.argv[1:]]
    complaints = os.path.join(out, f"reproduce.{i}-of-{count}.log")
    job.program([program, *words, "--shard", f"{i}/{count}"], stdout=None, stderr=complaints)
client.wait_for_jobs([client.submit(job)])
