#!/bin/sh
# private_slurm.sh start|stop FOLDER: a Slurm of one node on the loopback, all of it in FOLDER.
set -eu
at=$2
export SLURM_CONF="$at/slurm.conf"
case $1 in
start)
    host=$(hostname -s)
    mkdir -p "$at/state" "$at/spool"
    chmod 755 "$at"
    dd if=/dev/urandom of="$at/munge.key" bs=1024 count=1 status=none
    chmod 600 "$at/munge.key"
    cat > "$SLURM_CONF" <<CONF
ClusterName=private
SlurmctldHost=$host(127.0.0.1)
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=socket=$at/munge.sock
CommunicationParameters=NoInAddrAny,NoCtldInAddrAny
SlurmctldPort=26917
SlurmdPort=26918
StateSaveLocation=$at/state
SlurmdSpoolDir=$at/spool
SlurmctldPidFile=$at/slurmctld.pid
SlurmdPidFile=$at/slurmd.pid
SlurmctldLogFile=$at/slurmctld.log
SlurmdLogFile=$at/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
ReturnToService=2
MpiDefault=none
MailProg=/bin/true
NodeName=$host NodeAddr=127.0.0.1 CPUs=$(nproc) State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
CONF
    munged --force --key-file="$at/munge.key" --socket="$at/munge.sock" \
        --pid-file="$at/munged.pid" --log-file="$at/munged.log" --seed-file="$at/munge.seed"
    sleep 1
    slurmctld -c -f "$SLURM_CONF"
    slurmd -f "$SLURM_CONF"
    for _ in $(seq 60); do
        [ "$(sinfo -h -o %T 2>/dev/null)" = idle ] && exit 0
        sleep 0.5
    done
    exit 1
    ;;
stop)
    for daemon in slurmd slurmctld munged; do
        [ -f "$at/$daemon.pid" ] && kill "$(cat "$at/$daemon.pid")" || true
    done
    sleep 2
    ;;
esac
