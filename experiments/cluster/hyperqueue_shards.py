#!/usr/bin/env python3
"""Shards as tasks of one HyperQueue job: on the server in HQ_SERVER_DIR, or else on WORKERS workers of this machine."""
import os
from hyperqueue import Client, Job, LocalCluster
from hyperqueue.cluster import WorkerConfig

value, server = os.environ.get, os.environ.get("HQ_SERVER_DIR")
count, program, out = int(value("SHARDS", "16")), value("ZONOBENCH", "zonobench"), value("OUT", "out/shards")
cluster = None if server else LocalCluster()
for _ in range(0 if cluster is None else int(value("WORKERS", "2"))):
    cluster.start_worker(WorkerConfig(cores=1))
job, client = Job(max_fails=None), Client(server) if cluster is None else cluster.client()
for i in range(count):
    words = ["reproduce", "--profile", value("PROFILE", "full"), "--threads", "1", "--out", out]
    job.program([program, *words, "--shard", f"{i}/{count}"], stdout=None, stderr=None)
client.wait_for_jobs([client.submit(job)])
